// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/xyz_source.h"

#include "io/cloud/text_layout.h"
#include "io/cloud/text_table.h"
#include "io/text/text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace ridgeline::io {

bool has_xyz_name(const std::string& path) {
  constexpr std::array<std::string_view, 5> kEndings{".xyz", ".txt", ".csv", ".asc", ".pts"};
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

std::unique_ptr<CloudSource> open_xyz(MappedFile file, const std::string& path) {
  const auto bytes = file.bytes();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  TextLayout layout = find_text_layout(text, path);
  TextTable table{.file = std::move(file),
                  .offset = layout.offset,
                  .first_line = layout.first_line,
                  .items = std::move(layout.items),
                  .separator = layout.separator};
  return open_text_table(std::move(table), {.path = path, .format = "text"}, false);
}

}  // namespace ridgeline::io
