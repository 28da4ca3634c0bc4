// SPDX-License-Identifier: BSD-3-Clause
// Speed of LAZ decoding, by file and by how much of a record is decoded.
//   laz_benchmark FILE.laz [--benchmark_...]
#include "io/cloud/las_header.h"
#include "io/cloud/laz/laz_points.h"
#include "io/error.h"
#include "io/files/mapped_file.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cstdio>
#include <string>

namespace {

using namespace ridgeline::io;

// Chunks are independent, so decoding the chunks of a small file several times over in one loop
// stands for a large file.
constexpr std::size_t kRepetitions = 8;

void decode_chunks(benchmark::State& state,
                   const std::string& path,
                   laz::RecordParts parts,
                   std::size_t num_threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, num_threads);
  const MappedFile file(path);
  const LasHeader header = read_las_header(path);
  const laz::LazPoints points(file.bytes(), header, path);
  while (state.KeepRunning()) {
    tbb::parallel_for(std::size_t{0}, kRepetitions * points.n_blocks(), [&](std::size_t i) {
      points.decode(i % points.n_blocks(), parts,
                    [](std::span<const std::byte> records, std::size_t) {
                      benchmark::DoNotOptimize(records.data());
                    });
    });
  }
  const auto n_points = state.iterations() * kRepetitions * header.n_points;
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(n_points), benchmark::Counter::kIsRate);
}

void register_file(const std::string& path) {
  using laz::RecordParts;
  const std::pair<const char*, RecordParts> modes[] = {{"all", RecordParts::kAll},
                                                       {"cloud_point", RecordParts::kCloudPoint}};
  for (const auto& mode : modes) {
    for (const std::size_t num_threads : {1U, 2U}) {
      const std::string name = std::string(mode.first) + "/threads:" + std::to_string(num_threads);
      benchmark::RegisterBenchmark(name.c_str(), decode_chunks, path, mode.second, num_threads)
          ->MeasureProcessCPUTime()
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fputs("usage: laz_benchmark FILE.laz [--benchmark_...]\n", stderr);
    return 1;
  }
  try {
    register_file(argv[1]);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const IoError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
