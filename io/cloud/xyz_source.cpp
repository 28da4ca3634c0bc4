// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/xyz_source.h"

#include "io/cloud/text_table.h"
#include "io/lines/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {

namespace {

/// The items that a line of column names announces; empty if the line starts with no letter. Such
/// a line may be commented out: "//X Y Z".
std::vector<TextItem> parse_column_names(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
  std::vector<TextItem> items;
  if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) return items;
  constexpr std::string_view kAroundNames = " \t\r,;\"";
  for (std::size_t first = 0; first != std::string_view::npos;
       first = line.find_first_not_of(kAroundNames)) {
    line.remove_prefix(first);
    const std::string_view name = line.substr(0, line.find_first_of(kAroundNames));
    items.push_back({.attribute = attribute_of_column(name)});
    line.remove_prefix(name.size());
  }
  return items;
}

bool names_coordinates(const std::vector<TextItem>& items) {
  return std::ranges::any_of(
      items, [](const TextItem& item) { return item.attribute == PointAttribute::kX; });
}

}  // namespace

bool has_xyz_name(const std::string& path) {
  constexpr std::array<std::string_view, 5> kEndings{".xyz", ".txt", ".csv", ".asc", ".pts"};
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

std::unique_ptr<CloudSource> open_xyz(MappedFile file, const std::string& path) {
  const auto bytes = file.bytes();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string_view first_line = text.substr(0, text.find('\n'));
  TextTable table{.file = std::move(file),
                  .items = {{.attribute = PointAttribute::kX},
                            {.attribute = PointAttribute::kY},
                            {.attribute = PointAttribute::kZ}}};
  if (std::vector<TextItem> named = parse_column_names(first_line); names_coordinates(named)) {
    table.items = std::move(named);
    table.offset = std::min(first_line.size() + 1, text.size());
    table.first_line = 2;
  }
  return open_text_table(std::move(table), {.path = path, .format = "text"}, false);
}

}  // namespace ridgeline::io
