// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/named_by_columns.h"

#include "io/error.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <vector>

namespace ridgeline::io {
namespace {

/// The texts of a column by row; empty where a feature has no value.
std::vector<std::string> texts_of(const LineSet& set, const std::string& name) {
  const std::vector<Column>& columns = set.features.columns;
  const auto is_it = [&](const Column& c) { return lower_case(c.name) == lower_case(name); };
  const auto found = std::ranges::find_if(columns, is_it);
  if (found == columns.end()) {
    const std::vector<std::string> known = transformed(columns, &Column::name);
    throw IoError(set.path,
                  fmt::format("has no column {}; it has {}", name,
                              known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
  }
  std::vector<std::string> texts(set.features.rows.size());
  for (std::size_t row = 0; row < texts.size(); ++row) {
    for (const auto& [column, value] : set.features.rows[row]) {
      if (column == static_cast<std::size_t>(found - columns.begin())) texts[row] = text_of(value);
    }
  }
  return texts;
}

void set_ids(const std::vector<std::string>& ids, LineSet& set) {
  for (Line& line : set.lines) {
    const std::string& id = ids.at(line.row);
    if (id.empty()) continue;
    const bool is_part = !line.parent_id.empty();
    line.id = is_part ? fmt::format("{}.{}", id, line.part) : id;
    if (is_part) line.parent_id = id;
  }
}

/// Renames the buildings of a model, and their edges, which are named after them.
void name_buildings(const std::vector<std::string>& names, LineSet& set) {
  BuildingModel model = *set.model;
  std::set<std::string> known;
  for (std::size_t b = 0; b < model.buildings.size(); ++b) {
    if (!names.at(b).empty()) model.buildings[b].id = names[b];
    if (!known.insert(model.buildings[b].id).second) {
      throw IoError(
          set.path,
          fmt::format("two buildings are called {}; the names of buildings must be unique",
                      model.buildings[b].id));
    }
  }
  for (Line& line : set.lines) {
    const std::string& name = model.buildings[line.row].id;
    if (line.id.starts_with(line.building + ".")) line.id.replace(0, line.building.size(), name);
    line.building = name;
  }
  set.model = std::make_shared<const BuildingModel>(std::move(model));
}

void set_buildings(const std::vector<std::string>& names, LineSet& set) {
  if (set.model) return name_buildings(names, set);
  for (Line& line : set.lines)
    if (!names.at(line.row).empty()) line.building = names[line.row];
}

}  // namespace

void name_by_columns(const std::string& id_column,
                     const std::string& building_column,
                     LineSet& set) {
  if (!id_column.empty()) {
    if (set.model)
      throw IoError(
          set.path,
          "is a model, whose edges have no id column; name the id column of its buildings instead");
    set_ids(texts_of(set, id_column), set);
  }
  if (building_column.empty()) return;
  const bool states_ids = set.format.starts_with("CityJSON") || set.format.starts_with("CityGML");
  if (set.model && states_ids)
    throw IoError(set.path, "already has building ids; do not give a column for them");
  set_buildings(texts_of(set, building_column), set);
}

}  // namespace ridgeline::io
