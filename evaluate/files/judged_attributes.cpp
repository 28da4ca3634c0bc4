// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_attributes.h"

#include "evaluate/files/map_layers.h"
#include "evaluate/files/output_folder.h"
#include "io/files/atomic_file.h"
#include "io/gdal/geopackage_writer.h"
#include "io/models/add_attributes.h"
#include "io/models/read_model.h"
#include "io/models/write_model.h"
#include "io/text/text.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace ridgeline::results {
namespace {

constexpr const char* kPrefix = "ridgeline_";

/// The columns of the figures with our prefix, which avoids clashes with columns of a model.
std::vector<io::Column> prefixed_columns() {
  std::vector<io::Column> columns = building_columns();
  for (io::Column& column : columns) column.name = kPrefix + column.name;
  return columns;
}

bool is_json(const std::string& file) {
  const std::string lower = io::lower_case(file);
  return lower.ends_with(".json") || lower.ends_with(".jsonl");
}

/// std::nullopt if buildings of the file share an id.
std::optional<std::string> city_json(const io::LineSet& set, const JudgedModel& model) {
  io::BuildingValues values;
  for (std::size_t b = 0; b < model.rows.size(); ++b)
    values[model.buildings[b].id] = building_values(model.rows[b], 0);
  return io::with_attributes(set.path, io::text_of_model(set.path), prefixed_columns(), values);
}

/// A table without the figures of an earlier judging.
io::AttributeTable without_figures(const io::AttributeTable& table) {
  const std::vector<io::Column> figures = prefixed_columns();
  std::vector<std::optional<std::size_t>> kept_as;
  io::AttributeTable kept;
  for (const io::Column& column : table.columns) {
    const bool is_figure =
        std::ranges::find(figures, column.name, &io::Column::name) != figures.end();
    kept_as.push_back(is_figure ? std::nullopt : std::optional(kept.columns.size()));
    if (!is_figure) kept.columns.push_back(column);
  }
  for (const io::SparseRow& row : table.rows) {
    io::SparseRow& values = kept.rows.emplace_back();
    for (const auto& [column, value] : row)
      if (kept_as[column]) values.emplace_back(*kept_as[column], value);
  }
  return kept;
}

/// The model with its reference system, and with the figures appended to the attributes of its
/// file.
io::BuildingModel with_figures(const io::LineSet& set,
                               const JudgedModel& judged,
                               const io::Crs& cloud_crs) {
  io::BuildingModel model = *set.model;
  model.crs = set.crs.known() ? set.crs : cloud_crs;
  model.attributes = without_figures(set.features);
  const std::size_t first = model.attributes.columns.size();
  std::ranges::move(prefixed_columns(), std::back_inserter(model.attributes.columns));
  model.attributes.rows.resize(model.buildings.size());
  for (std::size_t b = 0; b < model.buildings.size(); ++b) {
    std::ranges::move(building_values(judged.rows[b], first),
                      std::back_inserter(model.attributes.rows[b]));
  }
  return model;
}

}  // namespace

void check_attributes_file(const std::string& file) {
  const std::string lower = io::lower_case(file);
  check(is_json(file) || lower.ends_with(".gml") || lower.ends_with(".gpkg"),
        "`write_attributes` = ", file, ", must end in .json, .jsonl, .gml or .gpkg");
}

void write_model_with_figures(const std::string& file, const JudgedFiles& judged, std::size_t i) {
  const io::LineSet& set = judged.line_sets[i];
  const JudgedModel& model = *judged.models[i];
  if (io::lower_case(file).ends_with(".gpkg")) {
    const ToMap to_map(judged.evaluations[i].origin_m, unit_m_of(set));
    io::write_geopackage(file, set.crs.known() ? set.crs : judged.cloud_crs,
                         model_layers(model, without_figures(set.features), to_map));
    return;
  }
  if (is_json(file) && set.format.starts_with("CityJSON")) {
    if (const std::optional<std::string> text = city_json(set, model))
      return io::write_file(file, *text);
  }
  io::write_model(file, with_figures(set, model, judged.cloud_crs),
                  is_json(file) ? io::ModelFormat::kCityJson : io::ModelFormat::kCityGml);
}

}  // namespace ridgeline::results
