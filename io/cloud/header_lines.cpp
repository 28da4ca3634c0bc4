// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/header_lines.h"

#include "io/error.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace ridgeline::io {

HeaderLines::HeaderLines(std::span<const std::byte> file, std::string file_path)
    : text_(reinterpret_cast<const char*>(file.data()), file.size()), path_(std::move(file_path)) {}

std::vector<std::string_view> HeaderLines::next() {
  constexpr std::size_t kMaxLineLength = 65536;
  ++line_;
  const std::size_t end = text_.substr(offset_, kMaxLineLength).find('\n');
  if (end == std::string_view::npos) fail("the header does not end");
  std::string_view line = text_.substr(offset_, end);
  offset_ += end + 1;
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\r";
  for (std::size_t first = line.find_first_not_of(kBlanks); first != std::string_view::npos;
       first = line.find_first_not_of(kBlanks)) {
    line.remove_prefix(first);
    words.push_back(line.substr(0, line.find_first_of(kBlanks)));
    line.remove_prefix(words.back().size());
  }
  return words;
}

void HeaderLines::fail(const std::string& message) const {
  throw IoError(path_, fmt::format("line {}: {}", line_, message));
}

std::uint64_t HeaderLines::parse_count(std::string_view word, std::string_view what) const {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) {
    fail(fmt::format("{} is \"{}\"; must be a whole number", what, word));
  }
  return value;
}

}  // namespace ridgeline::io
