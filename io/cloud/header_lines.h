// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Walks the text header of a PCD or PLY file line by line, up to where the data begins.
class HeaderLines {
 public:
  HeaderLines(std::span<const std::byte> file, std::string file_path);

  /// The words of the next line. Throws IoError if the header does not end: at the end of the file,
  /// or if a line is too long for a header.
  std::vector<std::string_view> next();

  /// Byte offset of the line that next() will read.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  /// Number of the last line read, from 1.
  [[nodiscard]] std::uint64_t line_number() const { return line_; }

  /// Throws IoError with the message "line N: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;

  /// The word as an integer from 0 to 2^64 - 1. Throws IoError naming `what` if it is not one.
  [[nodiscard]] std::uint64_t parse_count(std::string_view word, std::string_view what) const;

 private:
  std::string_view text_;
  std::string path_;
  std::size_t offset_ = 0;
  std::uint64_t line_ = 0;
};

}  // namespace ridgeline::io
