// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/ply_header.h"

#include "io/cloud/header_lines.h"

#include <fmt/format.h>

#include <string_view>

namespace ridgeline::io {

namespace {

using Words = std::vector<std::string_view>;

PlyEncoding parse_encoding(const Words& words, const HeaderLines& lines) {
  if (words.size() < 2) lines.fail("the format line has no encoding");
  if (words[1] == "ascii") return PlyEncoding::kAscii;
  if (words[1] == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (words[1] == "binary_big_endian") return PlyEncoding::kBigEndian;
  lines.fail(fmt::format("format is {}; must be ascii, binary_little_endian or binary_big_endian",
                         words[1]));
}

ScalarType parse_type(std::string_view name, const HeaderLines& lines) {
  const auto type = scalar_type_of_ply_name(name);
  if (!type) lines.fail(fmt::format("\"{}\" is not a PLY type", name));
  return *type;
}

PlyProperty parse_property(const Words& words, const HeaderLines& lines) {
  const bool is_list = words.size() > 1 && words[1] == "list";
  if (words.size() != (is_list ? 5U : 3U)) {
    lines.fail("a property must be \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
  }
  PlyProperty property{.name = std::string(words.back()),
                       .type = parse_type(words[words.size() - 2], lines)};
  if (is_list) property.list_count_type = parse_type(words[2], lines);
  return property;
}

}  // namespace

std::optional<std::uint64_t> PlyElement::row_size() const {
  std::uint64_t size = 0;
  for (const PlyProperty& property : properties) {
    if (property.list_count_type) return std::nullopt;
    size += size_of(property.type);
  }
  return size;
}

PlyHeader read_ply_header(std::span<const std::byte> file, const std::string& path) {
  PlyHeader header;
  HeaderLines lines(file, path);
  if (const Words first = lines.next(); first != Words{"ply"}) lines.fail("must be \"ply\"");
  bool has_format = false;
  for (Words words = lines.next(); words != Words{"end_header"}; words = lines.next()) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format") {
      header.encoding = parse_encoding(words, lines);
      has_format = true;
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({.name = std::string(words[1]),
                                 .count = lines.parse_count(words[2], "element count"),
                                 .properties = {}});
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parse_property(words, lines));
    } else {
      lines.fail(fmt::format("\"{}\" is not expected here", words[0]));
    }
  }
  if (!has_format) lines.fail("the header has no format line");
  header.data_offset = lines.offset();
  header.data_line = lines.line_number();
  return header;
}

}  // namespace ridgeline::io
