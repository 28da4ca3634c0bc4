// SPDX-License-Identifier: BSD-3-Clause
// Time of the comparison with true lines against their number, and of finding the lines near each
// by an R-tree against comparing it with all.
#include "evaluate/statistics/parameter_intervals.h"
#include "evaluate/statistics/reference_errors.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/epipolar.h"
#include "tests/support/random.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kTolerance_m = 0.3;

/// Lines of 8 m, one on every 100 m2, as a larger town has more of.
std::vector<Segment3> town_lines(std::size_t n) {
  test::Random random(1);
  const double side_m = 10.0 * std::sqrt(static_cast<double>(n));
  std::vector<Segment3> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d start(random.uniform(0.0, side_m), random.uniform(0.0, side_m),
                                random.uniform(3.0, 12.0));
    const double azimuth_rad = random.uniform(0.0, 3.14);
    lines.push_back(
        {start, start + 8.0 * Eigen::Vector3d(std::sin(azimuth_rad), std::cos(azimuth_rad), 0.0)});
  }
  return lines;
}

ProjectionMatrix camera_at(double x_m) {
  ProjectionMatrix p;
  p << 10000, 0, 0, -10000 * x_m, 0, -10000, 0, 0, 0, 0, -1, 800;
  return p;
}

void compare_with_references_of_a_town(benchmark::State& state) {
  const std::array<ProjectionMatrix, 2> cameras{camera_at(-104.0), camera_at(104.0)};
  std::vector<JudgedLine> lines;
  std::vector<ReferenceLine> truth;
  for (const Segment3& s : town_lines(static_cast<std::size_t>(state.range(0)))) {
    truth.push_back({s, "eave"});
    JudgedLine line;
    line.segment = s;
    line.line_class = "not_aligned";
    line.images.emplace().height_range_m = {-10.0, 30.0};
    for (const ProjectionMatrix& camera : cameras) {
      line.images->observations.push_back({camera, project(camera, s)});
    }
    lines.push_back(line);
  }
  for (auto _ : state) benchmark::DoNotOptimize(compare_with_references(lines, truth));
}
BENCHMARK(compare_with_references_of_a_town)
    ->Arg(1'000)
    ->Arg(4'000)
    ->Arg(16'000)
    ->Unit(benchmark::kMillisecond);

void lines_near_each_by_tree(benchmark::State& state) {
  const std::vector<Segment3> lines = town_lines(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    const BoxIndex3 tree(lines);
    std::size_t n = 0;
    for (const Segment3& s : lines) {
      for (const std::size_t i : tree.near(s, kTolerance_m)) {
        if (part_near(s, lines[i], kTolerance_m)) ++n;
      }
    }
    benchmark::DoNotOptimize(n);
  }
}
BENCHMARK(lines_near_each_by_tree)->Arg(1'000)->Arg(4'000)->Unit(benchmark::kMillisecond);

void lines_near_each_by_comparing_all(benchmark::State& state) {
  const std::vector<Segment3> lines = town_lines(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    std::size_t n = 0;
    for (const Segment3& s : lines) {
      for (const Segment3& other : lines) {
        if (part_near(s, other, kTolerance_m)) ++n;
      }
    }
    benchmark::DoNotOptimize(n);
  }
}
BENCHMARK(lines_near_each_by_comparing_all)->Arg(1'000)->Arg(4'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ridgeline::evaluate

BENCHMARK_MAIN();
