// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/record_parts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io::laz {

/// Path of a file below the folder of shared data, e.g. "las_samples/laspy_simple.laz".
std::string shared_file(const std::string& name);
bool have_shared_file(const std::string& name);

std::vector<std::byte> read_file(const std::string& path);

struct DecodedFile {
  std::vector<std::byte> records;  ///< uncompressed, in file order
  std::vector<std::string> warnings;
};

/// All records of a LAZ file in memory. Throws IoError as the reader does.
DecodedFile decode_laz(const std::vector<std::byte>& file, RecordParts parts = RecordParts::kAll);

/// The records of an uncompressed LAS file in memory.
std::vector<std::byte> las_records(const std::vector<std::byte>& file);

}  // namespace ridgeline::io::laz

/// Skips the test, naming the file, where the shared data are absent.
#define RIDGELINE_NEED_SHARED_FILE(name)                                                   \
  if (!ridgeline::io::laz::have_shared_file(name)) {                                       \
    GTEST_SKIP() << ridgeline::io::laz::shared_file(name) << " is absent: no shared data"; \
  }
