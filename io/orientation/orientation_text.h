// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Maximum number of bytes read from an orientation file; one row or element per image needs far
/// less.
constexpr std::uint64_t kMaxOrientation_bytes = std::uint64_t{32} << 20U;

/// The whole text of a regular file in UTF-8, without a byte order mark; bytes that are not UTF-8
/// are read as Latin-1. Throws IoError for a file that is missing, empty, larger than `most_bytes`
/// (before it is read), or not a text because it contains a zero byte.
std::string read_orientation_text(const std::string& path,
                                  std::uint64_t most_bytes = kMaxOrientation_bytes);

/// The text of the file `name` in the same folder as `path`, without trailing whitespace; empty if
/// there is no such file. Records the file in orientation.files_beside.
std::string text_beside(const std::string& path, std::string_view name, Orientation& orientation);

}  // namespace ridgeline::io
