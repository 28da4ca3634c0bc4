// SPDX-License-Identifier: BSD-3-Clause
// Writes the uncompressed records of a LAZ file to standard output, for compare.mjs.
#include "io/cloud/las_header.h"
#include "io/cloud/laz/laz_points.h"
#include "io/error.h"
#include "io/files/mapped_file.h"

#include <cstdio>

int main(int argc, char** argv) {
  using namespace ridgeline::io;
  if (argc != 2) {
    std::fputs("usage: laz_dump FILE.laz > RECORDS\n", stderr);
    return 1;
  }
  try {
    const MappedFile file(argv[1]);
    const laz::LazPoints points(file.bytes(), read_las_header(argv[1]), argv[1]);
    for (std::size_t block = 0; block < points.n_blocks(); ++block) {
      points.decode(block, laz::RecordParts::kAll,
                    [](std::span<const std::byte> records, std::size_t) {
                      std::fwrite(records.data(), 1, records.size(), stdout);
                    });
    }
  } catch (const IoError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}
