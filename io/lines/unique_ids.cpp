// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/unique_ids.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace ridgeline::io {
namespace {

std::size_t count_repeated_ids(const std::vector<Line>& lines) {
  std::unordered_set<std::string_view> known(lines.size());
  for (const Line& line : lines) known.insert(line.id);
  return lines.size() - known.size();
}

bool layers_share_ids(const LineSet& set) {
  std::unordered_map<std::string_view, int> layers;
  return std::ranges::any_of(set.lines, [&](const Line& line) {
    return layers.try_emplace(line.id, line.layer).first->second != line.layer;
  });
}

void name_by_layer(LineSet& set) {
  for (Line& line : set.lines) {
    const std::string prefix = set.layers[static_cast<std::size_t>(line.layer)] + ".";
    if (line.id.starts_with(prefix)) continue;  // the line had no id of its own
    line.id = prefix + line.id;
    if (!line.parent_id.empty()) line.parent_id = prefix + line.parent_id;
  }
  set.warnings.push_back(fmt::format(
      "ids repeat across layers; they are prefixed with the layer: {}", set.lines.front().id));
}

bool is_numbered_part(const Line& line) {
  return line.id == fmt::format("{}.{}", line.parent_id, line.part);
}

/// An id that no line has: `id` followed by a number.
std::string numbered(const std::string& id,
                     const std::unordered_set<std::string>& known,
                     int& last_number) {
  std::string name;
  do {
    name = fmt::format("{}.{}", id, ++last_number);
  } while (known.contains(name));
  return name;
}

void number_repeated(LineSet& set) {
  constexpr std::size_t kMaxShownIds = 3;
  std::unordered_set<std::string> known;
  std::vector<Line*> repeated;
  for (const bool of_parts : {false, true}) {
    for (Line& line : set.lines) {
      if (is_numbered_part(line) != of_parts) continue;
      if (!known.insert(line.id).second) repeated.push_back(&line);
    }
  }
  std::unordered_map<std::string, int> last_numbers;
  std::vector<std::string> shown;
  for (Line* const line : repeated) {
    line->id = numbered(line->id, known, last_numbers[line->id]);
    known.insert(line->id);
    if (shown.size() < kMaxShownIds) shown.push_back(line->id);
  }
  set.warnings.push_back(fmt::format(
      "{} lines repeat the id of an earlier line and get a number: {}{}", repeated.size(),
      fmt::join(shown, ", "), repeated.size() > kMaxShownIds ? ", ..." : ""));
}

}  // namespace

void make_ids_unique(LineSet& set) {
  if (count_repeated_ids(set.lines) == 0) return;
  if (set.layers.size() > 1 && layers_share_ids(set)) name_by_layer(set);
  if (count_repeated_ids(set.lines) > 0) number_repeated(set);
}

}  // namespace ridgeline::io
