// SPDX-License-Identifier: BSD-3-Clause
// Reading a COPC file of 8 million points over 1 km2: the whole, a window of 1 % of the area, the
// surroundings of lines in that window, and a quick look at a coarse resolution.

#include "io/cloud/read_cloud.h"
#include "tests/io/laz/copc_builder.h"

#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace ridgeline;

constexpr std::size_t kPoints = 8'000'000;
constexpr std::int32_t kSide = 100'000;  // 1 km in steps of 1 cm

/// Removed when the program ends.
class CopcFile {
 public:
  CopcFile() : path_(std::filesystem::temp_directory_path() / "ridgeline_copc_benchmark.laz") {
    std::mt19937_64 rng(1);
    std::vector<io::laz::CopcPoint> points(kPoints);
    for (io::laz::CopcPoint& point : points) {
      point.x = {static_cast<std::int32_t>(rng() % kSide), static_cast<std::int32_t>(rng() % kSide),
                 static_cast<std::int32_t>(rng() % 2000)};
    }
    const auto file = io::laz::CopcBuilder{.n_levels = 6}.build(points);
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()),
               static_cast<std::streamsize>(file.size()));
  }
  ~CopcFile() { std::filesystem::remove(path_); }
  CopcFile(const CopcFile&) = delete;
  CopcFile& operator=(const CopcFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

void read(benchmark::State& state, const io::ReadOptions& options) {
  static const CopcFile file;
  std::size_t n_kept = 0;
  for (auto _ : state) n_kept = io::read_cloud({file.path()}, options).points.size();
  state.counters["kept_points"] = static_cast<double>(n_kept);
}

io::ReadOptions in_local_frame() {
  io::ReadOptions options;
  options.frame = LocalFrame{};
  return options;
}

void read_whole(benchmark::State& state) { read(state, in_local_frame()); }

void read_window(benchmark::State& state) {
  io::ReadOptions options = in_local_frame();
  options.bounds_in_file =
      Eigen::AlignedBox3d(Eigen::Vector3d(430.0, 620.0, -1e3), Eigen::Vector3d(530.0, 720.0, 1e3));
  read(state, options);
}

void read_near_lines(benchmark::State& state) {
  const std::array<Segment2, 3> lines{Segment2{{430.0, 620.0}, {445.0, 620.0}},
                                      Segment2{{480.0, 700.0}, {490.0, 710.0}},
                                      Segment2{{530.0, 650.0}, {530.0, 660.0}}};
  io::ReadOptions options = in_local_frame();
  options.near = io::PlanMask(lines, 6.0);
  read(state, options);
}

void read_coarse(benchmark::State& state) {
  io::ReadOptions options = in_local_frame();
  options.max_resolution_m = 4.0;
  read(state, options);
}

BENCHMARK(read_whole)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(read_window)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(read_near_lines)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(read_coarse)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
