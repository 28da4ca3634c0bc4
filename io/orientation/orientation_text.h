// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// The most bytes of a file of an orientation that are read; one row or element an image is far
/// less.
constexpr std::uint64_t kMaxOrientation_bytes = std::uint64_t{32} << 20U;

/// The whole text of a regular file, without the byte order mark of UTF-8. Throws IoError for a
/// file that is missing, empty, larger than `most_bytes` (before it is read), or not a text because
/// it holds a zero byte.
std::string read_orientation_text(const std::string& path,
                                  std::uint64_t most_bytes = kMaxOrientation_bytes);

/// The text of a file in the same folder as `path`, without what is blank at its end; empty if
/// there is none.
std::string text_beside(const std::string& path, std::string_view name);

}  // namespace ridgeline::io
