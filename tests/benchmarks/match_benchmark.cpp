// SPDX-License-Identifier: BSD-3-Clause
// Time of the pair-wise matching against the area of the images, at 1500 segments per megapixel.
#include "reconstruct/match/ok2011/match_pairwise.h"
#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/support/random.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kSegmentsPerPixel = 1.5e-3;

cv::Mat noise_image(int size_px, test::Random& random) {
  cv::Mat image(size_px, size_px, CV_32FC3);
  for (int row = 0; row < size_px; ++row) {
    auto* values = image.ptr<float>(row);
    for (int i = 0; i < 3 * size_px; ++i) {
      values[i] = static_cast<float>(random.bits() >> 40U) * 0x1.0p-24F;
    }
  }
  return image;
}

/// Lines 0.8 m to 6 m long between 0 m and 15 m height, as both images see them.
std::array<View, 2> random_views(int size_px) {
  test::Random random(1);
  const test::StereoPair pair;
  std::array<View, 2> views;
  views[0].image_from_local = pair.left;
  views[1].image_from_local = pair.right;
  for (View& view : views) view.image = noise_image(size_px, random);
  const double extent_m = 0.08 * size_px;
  const auto n = static_cast<int>(kSegmentsPerPixel * size_px * size_px);
  for (int i = 0; i < n; ++i) {
    // rows of the image run down, y runs up
    const Eigen::Vector3d start(random.uniform(0.0, extent_m), -random.uniform(0.0, extent_m),
                                random.uniform(0.0, 15.0));
    const double azimuth = random.uniform(0.0, 2.0 * M_PI);
    const double length_m = random.uniform(0.8, 6.0);
    const Eigen::Vector3d run(length_m * std::cos(azimuth), length_m * std::sin(azimuth), 0.0);
    for (View& view : views) {
      view.segments.push_back(
          test::edge(project(view.image_from_local, Segment3{start, start + run})));
    }
  }
  return views;
}

void match_of_size(benchmark::State& state) {
  const std::array<View, 2> views = random_views(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(match_pairwise({{views.data(), views.data() + 1}, {-10.0, 40.0}}));
  }
  state.counters["segments"] = static_cast<double>(views[0].segments.size());
}
BENCHMARK(match_of_size)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace ridgeline::reconstruct

BENCHMARK_MAIN();
