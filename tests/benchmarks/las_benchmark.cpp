// SPDX-License-Identifier: BSD-3-Clause
// Reading LAS from the page cache: points a second.

#include "io/cloud/las_writer.h"
#include "io/cloud/read_cloud.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace ridgeline;

constexpr std::size_t kPoints = 10'000'000;

/// A cloud of 10 million points over 1 km2, point format 6; removed when the program ends.
class LasFile {
 public:
  LasFile() : path_(std::filesystem::temp_directory_path() / "ridgeline_las_benchmark.las") {
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> plan(-500.0, 500.0);
    std::vector<io::CloudPoint> points(kPoints);
    for (io::CloudPoint& point : points) {
      point = {.x = plan(rng),
               .y = plan(rng),
               .z = 0.01 * plan(rng),
               .intensity = 100,
               .classification = 6,
               .return_number = 1,
               .number_of_returns = 1,
               .flags = 0,
               .source_id = 1};
    }
    io::write_las(path_.string(), points, {.origin_m = {513000.0, 5403000.0, 300.0}});
  }
  ~LasFile() { std::filesystem::remove(path_); }
  LasFile(const LasFile&) = delete;
  LasFile& operator=(const LasFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

const LasFile& las_file() {
  static const LasFile file;
  return file;
}

void read_whole(benchmark::State& state) {
  const std::string path = las_file().path();
  for (auto _ : state) {
    benchmark::DoNotOptimize(io::read_cloud({path}).points.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints));
}
BENCHMARK(read_whole)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void read_near_lines(benchmark::State& state) {
  const std::string path = las_file().path();
  io::ReadOptions options;
  options.frame = LocalFrame{.origin_m = {513000.0, 5403000.0, 300.0}};
  std::vector<Segment2> lines;
  for (double x = -450.0; x < 450.0; x += 30.0) {
    for (double y = -450.0; y < 450.0; y += 30.0) lines.push_back({{x, y}, {x + 10.0, y + 5.0}});
  }
  options.near = io::PlanMask(lines, 2.0);
  std::size_t n_kept = 0;
  for (auto _ : state) n_kept = io::read_cloud({path}, options).points.size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints));
  state.counters["kept_points"] = static_cast<double>(n_kept);
}
BENCHMARK(read_near_lines)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
