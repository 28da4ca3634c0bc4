// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/extract_segments.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// A textured scene of 1000 x 1000 pixels, repeated to `size_px` x `size_px`.
cv::Mat scene(int size_px) {
  static const cv::Mat tile = test::blurred_scene(1, {.size_px = 1000}).raw;
  cv::Mat image;
  cv::repeat(tile, size_px / 1000, size_px / 1000, image);
  return image;
}

void normalise(benchmark::State& state) {
  const cv::Mat raw = scene(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(normalised_image(raw));
}

void extract(benchmark::State& state) {
  const cv::Mat image = normalised_image(scene(static_cast<int>(state.range(0))));
  ExtractOptions options;
  std::size_t n = 0;
  for (auto _ : state) {
    const auto segments = extract_segments(image, {}, options);
    n = segments.size();
  }
  state.counters["segments"] = static_cast<double>(n);
}

/// Accuracy beside time: one image of 1000 x 1000 pixels with 400 true edges of common contrast.
void accuracy(benchmark::State& state) {
  const test::BlurredScene scene = test::blurred_scene(101, {.size_px = 1000});
  const cv::Mat image = normalised_image(scene.raw);
  ExtractOptions options;
  std::vector<EdgeSegment> segments;
  for (auto _ : state) segments = extract_segments(image, {}, options);
  const auto summary = test::summary(test::edge_errors(scene.edges, segments), scene.edges);
  state.counters["rms_px"] = summary.rms_px;
  state.counters["bias_px"] = summary.bias_px;
  state.counters["complete"] = summary.completeness;
  state.counters["across_z2"] = summary.across_z2;
  state.counters["angle_z2"] = summary.angle_z2;
}

BENCHMARK(normalise)
    ->Arg(1000)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(extract)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(accuracy)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace ridgeline::reconstruct

BENCHMARK_MAIN();
