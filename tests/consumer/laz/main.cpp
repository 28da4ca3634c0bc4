// SPDX-License-Identifier: BSD-3-Clause
// Counts the points of a LAS or LAZ file, of the latter by decoding them.
#include "io/cloud/las_header.h"
#include "io/cloud/laz/laz_points.h"
#include "io/error.h"
#include "io/files/mapped_file.h"

#include <cstdio>

int main(int argc, char** argv) {
  using namespace ridgeline::io;
  if (argc != 2) return 1;
  try {
    const LasHeader header = read_las_header(argv[1]);
    std::size_t n_points = header.is_compressed() ? 0 : header.n_points;
    if (header.is_compressed()) {
      const MappedFile file(argv[1]);
      const laz::LazPoints points(file.bytes(), header, argv[1]);
      for (std::size_t block = 0; block < points.n_blocks(); ++block) {
        points.decode(block, laz::RecordParts::kAll,
                      [&](std::span<const std::byte> records, std::size_t) {
                        n_points += records.size() / header.record_length;
                      });
      }
    }
    std::printf("%zu points\n", n_points);
    return n_points > 0 ? 0 : 1;
  } catch (const IoError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
