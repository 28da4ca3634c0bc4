// SPDX-License-Identifier: BSD-3-Clause
// Writes small binary files for the fuzzers to start from: make_seeds FOLDER gives
// FOLDER/TARGET/NAME.
#include "io/cloud/laz/laz_points.h"
#include "tests/io/cloud/las_bytes.h"
#include "tests/io/laz/copc_builder.h"
#include "tests/io/laz/laz_builder.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace ridgeline::io;
using laz::FileBytes;

class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void write(const std::string& target, const std::string& name, std::span<const std::byte> bytes) {
    std::filesystem::create_directories(folder_ / target);
    std::ofstream(folder_ / target / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }

 private:
  std::filesystem::path folder_;
};

/// An uncompressed file of every point format, the newer ones with an EVLR.
void write_las(Seeds& seeds) {
  for (std::uint8_t format = 0; format <= 10; ++format) {
    LasBytes las(format >= 6 ? 4 : 2, format, format % 3);
    las.add_vlr("LASF_Projection", 34735, geotiff_directory({{3072, 25832}, {4096, 7837}}));
    for (std::int32_t i = 0; i < 5; ++i) las.add_point({i, -i, 9 * i});
    if (format >= 6) {
      las.set<std::uint64_t>(235, las.bytes().size()).set<std::uint32_t>(243, 1);
      las.add_tail(std::string(60, '\0'));
    }
    const std::string bytes = las.bytes();
    seeds.write("las", "format" + std::to_string(format), std::as_bytes(std::span(bytes)));
  }
}

std::vector<laz::CopcPoint> points() {
  std::mt19937 rng(3);
  std::vector<laz::CopcPoint> points(200);
  for (laz::CopcPoint& point : points) {
    for (std::int32_t& x : point.x) x = static_cast<std::int32_t>(rng() % 5000);
    point.classification = static_cast<std::uint8_t>(2 + rng() % 5);
  }
  return points;
}

void write_laz(Seeds& seeds) {
  using Table = laz::LazBuilder::Table;
  for (const Table table : {Table::kBehindChunks, Table::kAtEndOfFile, Table::kMissing}) {
    laz::LazBuilder builder;
    builder.table = table;
    for (std::int32_t i = 0; i < 4; ++i) builder.add_single_point(i, 2 * i, -i);
    seeds.write("laz_file", "pointwise" + std::to_string(static_cast<int>(table)), builder.build());
  }
  const FileBytes copc = laz::CopcBuilder{.n_levels = 3, .entries_per_page = 8}.build(points());
  seeds.write("laz_file", "layered", copc);
  seeds.write("copc", "pages", copc);
  seeds.write("copc", "one_page", laz::CopcBuilder{.n_levels = 2}.build(points()));
}

/// A chunk behind the byte that chooses its items: layered, version 3, the core alone.
void write_chunks(Seeds& seeds) {
  FileBytes seed{std::byte{0x01}};
  const FileBytes chunk = laz::encode_layered_chunk(points());
  seed.insert(seed.end(), chunk.begin(), chunk.end());
  seeds.write("laz_chunk", "layered", seed);
  seeds.write("laz_chunk", "empty", FileBytes(100));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_seeds FOLDER\n", stderr);
    return 1;
  }
  Seeds seeds(argv[1]);
  write_las(seeds);
  write_laz(seeds);
  write_chunks(seeds);
  return 0;
}
