// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/dxf_header.h"

#include "io/text/text.h"
#include "io/text/utf8.h"

#include <array>
#include <optional>
#include <utility>

namespace ridgeline::io {
namespace {

/// A code, which gives the meaning of a value, and the value, one row each.
struct DxfGroup {
  long code = -1;
  std::string_view value;
};

class DxfGroups {
 public:
  explicit DxfGroups(std::string_view content) : rest_(content) {}

  /// The next group; std::nullopt at the end and if the rows are not groups.
  std::optional<DxfGroup> next() {
    if (rest_.empty()) return std::nullopt;
    const std::optional<long> code = to_integer(row());
    if (!code) return std::nullopt;
    return DxfGroup{*code, row()};
  }

 private:
  std::string_view row() {
    const std::size_t end = rest_.find('\n');
    const std::string_view text = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return text;
  }

  std::string_view rest_;
};

/// The name of a unit of $INSUNITS; empty for metres (6) and none (0), which need no name.
std::string unit_name(long code) {
  constexpr std::array<std::pair<long, const char*>, 11> kUnits{{{1, "inches"},
                                                                 {2, "feet"},
                                                                 {3, "miles"},
                                                                 {4, "millimetres"},
                                                                 {5, "centimetres"},
                                                                 {7, "kilometres"},
                                                                 {8, "microinches"},
                                                                 {9, "mils"},
                                                                 {10, "yards"},
                                                                 {14, "decimetres"},
                                                                 {21, "US survey feet"}}};
  for (const auto& [known, name] : kUnits) {
    if (known == code) return name;
  }
  return "";
}

/// The part of a layer table entry that is read.
struct DxfLayer {
  std::string name;
  bool is_frozen = false, is_off = false;
};

void take_group(const DxfGroup& group, DxfLayer& layer) {
  const long number = to_integer(group.value).value_or(0);
  constexpr unsigned long kFrozen = 1;
  if (group.code == 2) layer.name = lower_case(as_utf8(group.value));
  if (group.code == 70) layer.is_frozen = (static_cast<unsigned long>(number) & kFrozen) != 0;
  if (group.code == 62) layer.is_off = number < 0;  // a layer that is off has a negative colour
}

}  // namespace

DxfHeader dxf_header(std::string_view content) {
  DxfHeader header;
  DxfGroups groups(content);
  std::optional<DxfLayer> layer;
  bool is_insunits = false;
  while (const std::optional<DxfGroup> group = groups.next()) {
    if (group->code == 0) {
      if (layer && (layer->is_frozen || layer->is_off)) header.hidden_layers.insert(layer->name);
      layer.reset();
      if (group->value == "LAYER") layer.emplace();
    }
    if (group->code == 2 && (group->value == "BLOCKS" || group->value == "ENTITIES") && !layer)
      break;
    if (layer) take_group(*group, *layer);
    if (is_insunits && group->code == 70)
      header.unit = unit_name(to_integer(group->value).value_or(0));
    is_insunits = group->code == 9 && group->value == "$INSUNITS";
  }
  return header;
}

}  // namespace ridgeline::io
