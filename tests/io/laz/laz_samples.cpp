// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/laz/laz_samples.h"

#include "io/cloud/las_header.h"
#include "io/cloud/laz/laz_points.h"
#include "io/files/mapped_file.h"
#include "tests/support/paths.h"

#include <filesystem>

namespace ridgeline::io::laz {

std::string shared_file(const std::string& name) { return test::shared_data_dir() + "/" + name; }

bool have_shared_file(const std::string& name) {
  return std::filesystem::exists(shared_file(name));
}

std::vector<std::byte> read_file(const std::string& path) {
  const MappedFile file(path);
  return {file.bytes().begin(), file.bytes().end()};
}

DecodedFile decode_laz(const std::vector<std::byte>& file, RecordParts parts) {
  const LasHeader header = parse_las_header(file, "test.laz");
  const LazPoints points(file, header, "test.laz");
  DecodedFile decoded;
  decoded.warnings = points.warnings();
  for (std::size_t block = 0; block < points.n_blocks(); ++block) {
    points.decode(block, parts, [&](std::span<const std::byte> records, std::size_t) {
      decoded.records.insert(decoded.records.end(), records.begin(), records.end());
    });
  }
  return decoded;
}

std::vector<std::byte> las_records(const std::vector<std::byte>& file) {
  const LasHeader header = parse_las_header(file, "test.las");
  const auto first = file.begin() + static_cast<std::ptrdiff_t>(header.point_offset);
  return {first, first + static_cast<std::ptrdiff_t>(header.n_points * header.record_length)};
}

}  // namespace ridgeline::io::laz
