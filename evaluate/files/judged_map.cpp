// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_map.h"

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/map_layers.h"
#include "evaluate/files/map_style.h"
#include "evaluate/files/missing_layers.h"
#include "evaluate/files/to_fix.h"
#include "evaluate/judge/roof_kind.h"
#include "io/gdal/geopackage_writer.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::JudgedPlane;
using evaluate::JudgingPlane;
using evaluate::LineEvaluation;
using io::Column;
using io::ColumnType;
using io::Value;

constexpr double kDegrees = 180.0 / std::numbers::pi;

Value plane_id(const LineEvaluation& e, std::size_t i) {
  return i < e.planes.size() ? integer(static_cast<std::int64_t>(e.planes[i].id)) : Value();
}

Value least_coverage(const LineEvaluation& e) {
  if (e.planes.empty()) return {};
  return number(std::ranges::min(e.planes, {}, &JudgingPlane::coverage).coverage);
}

Value sigma_of(const LineEvaluation& e) {
  if (!e.sigma_plane_m) return {};
  return number(std::hypot(e.sigma_line_m.value_or(0.0), *e.sigma_plane_m));
}

/// A judged line with its data for the map.
struct JudgedMapLine {
  const LineEvaluation& e;
  const io::Line& line;
  std::string kind;                                  ///< roof_kind()
  Eigen::Vector3d moved_m{Eigen::Vector3d::Zero()};  ///< by which the line was moved before
};

using LineField = MapField<JudgedMapLine>;

const std::vector<LineField>& line_fields() {
  static const std::vector<LineField> fields{
      {"source_fid", ColumnType::kInteger64,
       [](const auto& m) { return integer(m.line.source_fid); }},
      {"part", ColumnType::kInteger, [](const auto& m) { return integer(m.line.part); }},
      {"line_id", ColumnType::kText, [](const auto& m) { return text(m.e.id); }},
      {"class", ColumnType::kText, [](const auto& m) { return text(m.e.line_class); }},
      {"status", ColumnType::kText, [](const auto& m) { return text(evaluate::name(m.e.status)); }},
      {"reason", ColumnType::kText, [](const auto& m) { return text(m.e.reason); }},
      {"kind", ColumnType::kText, [](const auto& m) { return text(m.kind); }},
      {"flags", ColumnType::kText,
       [](const auto& m) { return text(fmt::format("{}", fmt::join(m.e.flags, ";"))); }},
      {"surface", ColumnType::kText, [](const auto& m) { return text(name(m.e.surface)); }},
      {"surface_other", ColumnType::kText,
       [](const auto& m) { return text(name(m.e.surface_other)); }},
      {"surface_probability", ColumnType::kReal,
       [](const auto& m) { return number(m.e.surface_probability); }},
      {"decided_by", ColumnType::kText, [](const auto& m) { return text(name(m.e.decided_by)); }},
      {"length_m", ColumnType::kReal, [](const auto& m) { return number(m.e.length_m); }},
      {"mean_distance_m", ColumnType::kReal,
       [](const auto& m) { return number(m.e.mean_distance_m); }},
      {"signed_mean_m", ColumnType::kReal, [](const auto& m) { return number(m.e.signed_mean_m); }},
      {"max_distance_m", ColumnType::kReal,
       [](const auto& m) { return number(m.e.max_distance_m); }},
      {"horizontal_m", ColumnType::kReal,
       [](const auto& m) {
         return m.e.displacement ? number(m.e.displacement->horizontal_m) : Value();
       }},
      {"vertical_m", ColumnType::kReal,
       [](const auto& m) {
         return m.e.displacement ? number(m.e.displacement->vertical_m) : Value();
       }},
      {"height_if_vertical_m", ColumnType::kReal,
       [](const auto& m) { return number(m.e.height_if_vertical_m); }},
      {"sigma_m", ColumnType::kReal, [](const auto& m) { return sigma_of(m.e); }},
      {"z", ColumnType::kReal, [](const auto& m) { return number(m.e.z); }},
      {"plane_1", ColumnType::kInteger64, [](const auto& m) { return plane_id(m.e, 0); }},
      {"plane_2", ColumnType::kInteger64, [](const auto& m) { return plane_id(m.e, 1); }},
      {"coverage", ColumnType::kReal, [](const auto& m) { return least_coverage(m.e); }},
      {"n_images", ColumnType::kInteger,
       [](const auto& m) { return m.line.n_images ? integer(*m.line.n_images) : Value(); }}};
  return fields;
}

/// A deviation in whole centimetres, rounded up so that it never looks too good.
Value centimetres(std::optional<double> x_m) {
  if (!x_m || !std::isfinite(*x_m)) return {};
  return integer(static_cast<std::int64_t>(std::ceil(std::abs(*x_m) * 100.0)));
}

std::string fkb_type(const JudgedMapLine& m) {
  if (m.kind.empty()) return "";
  if (m.kind == "step") return "Taksprang";
  return m.kind == "eave" || m.kind == "verge" ? "Takkant" : "M\xC3\xB8nelinje";
}

/// Attributes of the Norwegian specification FKB-Bygning.
const std::vector<LineField>& fkb_fields() {
  static const std::vector<LineField> fields{
      {"objtype", ColumnType::kText, [](const auto& m) { return text(fkb_type(m)); }},
      {"n\xC3\xB8yaktighet", ColumnType::kInteger,
       [](const auto& m) {
         return centimetres(m.e.displacement ? m.e.displacement->horizontal_m
                                             : m.e.mean_distance_m);
       }},
      {"n\xC3\xB8yaktighetH\xC3\xB8yde", ColumnType::kInteger, [](const auto& m) {
         return centimetres(m.e.displacement ? m.e.displacement->vertical_m
                                             : m.e.height_if_vertical_m);
       }}};
  return fields;
}

/// Additional columns of lines that were moved before they were judged.
const std::vector<LineField>& moved_fields() {
  static const std::vector<LineField> fields{
      {"moved_x_m", ColumnType::kReal, [](const auto& m) { return number(m.moved_m.x()); }},
      {"moved_y_m", ColumnType::kReal, [](const auto& m) { return number(m.moved_m.y()); }},
      {"moved_z_m", ColumnType::kReal, [](const auto& m) { return number(m.moved_m.z()); }}};
  return fields;
}

/// Additional columns of the edges of building models.
const std::vector<LineField>& model_fields() {
  static const std::vector<LineField> fields{
      {"building", ColumnType::kText, [](const auto& m) { return text(m.line.building); }},
      {"stated_kind", ColumnType::kText, [](const auto& m) { return text(m.line.kind); }}};
  return fields;
}

bool is_moved(const evaluate::Evaluation& evaluation) {
  return evaluation.shift && evaluation.shift->applied;
}

std::vector<LineField> fields_of(const io::LineSet& set,
                                 MapSchema schema,
                                 const evaluate::Evaluation& evaluation) {
  std::vector<LineField> fields = line_fields();
  if (set.model) fields.insert(fields.end(), model_fields().begin(), model_fields().end());
  if (is_moved(evaluation)) {
    fields.insert(fields.end(), moved_fields().begin(), moved_fields().end());
  }
  if (schema == MapSchema::kFkb) {
    fields.insert(fields.end(), fkb_fields().begin(), fkb_fields().end());
  }
  return fields;
}

double normal_part(const JudgedPlane& p, int axis) { return p.plane.normal()[axis]; }

using PlaneField = MapField<JudgedPlane>;

const std::vector<PlaneField>& plane_fields() {
  static const std::vector<PlaneField> fields{
      {"plane_id", ColumnType::kInteger64,
       [](const auto& p) { return integer(static_cast<std::int64_t>(p.id)); }},
      {"normal_x", ColumnType::kReal, [](const auto& p) { return number(normal_part(p, 0)); }},
      {"normal_y", ColumnType::kReal, [](const auto& p) { return number(normal_part(p, 1)); }},
      {"normal_z", ColumnType::kReal, [](const auto& p) { return number(normal_part(p, 2)); }},
      {"slope_deg", ColumnType::kReal,
       [](const auto& p) { return number(slope_rad(p.plane) * kDegrees); }},
      {"aspect_deg", ColumnType::kReal, [](const auto& p) { return number(aspect_deg(p.plane)); }},
      {"rms_m", ColumnType::kReal, [](const auto& p) { return number(p.rms_m); }},
      {"inliers", ColumnType::kInteger, [](const auto& p) { return integer(p.n_inliers); }},
      {"n_lines", ColumnType::kInteger, [](const auto& p) { return integer(p.n_lines); }}};
  return fields;
}

using VectorField = MapField<LineEvaluation, JudgingPlane>;

const std::vector<VectorField>& vector_fields() {
  static const std::vector<VectorField> fields{
      {"line_id", ColumnType::kText, [](const auto& e, const auto&) { return text(e.id); }},
      {"plane_id", ColumnType::kInteger64,
       [](const auto&, const auto& p) { return integer(static_cast<std::int64_t>(p.id)); }},
      {"distance_m", ColumnType::kReal,
       [](const auto&, const auto& p) { return number(p.distance.mean); }}};
  return fields;
}

constexpr std::size_t kMaxInputColumns = 1900;  // an SQLite table has room for 2000

std::vector<Column> input_columns(const io::LineSet& set, const std::vector<LineField>& fields) {
  std::vector<Column> columns = renamed(set.features.columns, columns_of(fields));
  if (columns.size() > kMaxInputColumns) columns.resize(kMaxInputColumns);
  return columns;
}

io::SparseRow input_values(const io::LineSet& set, const io::Line& line, std::size_t n_columns) {
  io::SparseRow values;
  if (line.row >= set.features.rows.size()) return values;
  for (const auto& value : set.features.rows[line.row]) {
    if (value.first < n_columns) values.push_back(value);
  }
  return values;
}

io::MapLayer lines_layer(const io::LineSet& set,
                         const evaluate::Evaluation& evaluation,
                         const std::vector<JudgedPlane>& planes,
                         MapSchema schema) {
  const std::vector<LineField> fields = fields_of(set, schema, evaluation);
  io::MapLayer layer{
      .name = "lines",
      .description = is_moved(evaluation)
                         ? "Lines, shift removed, with their distances from LIDAR planes"
                         : "Lines with their distances from LIDAR planes",
      .geometry = io::MapGeometry::kLine,
      .columns = input_columns(set, fields),
      .features = {},
      .style = lines_style()};
  const std::size_t first = layer.columns.size();
  for (Column& column : columns_of(fields)) layer.columns.push_back(std::move(column));
  evaluate::PlanesById by_id;
  for (const JudgedPlane& plane : planes) by_id[plane.id] = &plane;
  const Eigen::Vector3d unit_m = unit_m_of(set);
  layer.features.reserve(set.lines.size());
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const io::Line& line = set.lines[i];
    const LineEvaluation& e = evaluation.lines[i];
    io::MapFeature feature;
    if (all_finite(line.segment_in_world)) {
      feature.vertices = {line.segment_in_world.start, line.segment_in_world.end};
    }
    feature.values = input_values(set, line, first);
    JudgedMapLine judged{
        e, line,
        evaluate::roof_kind(e, segment_in_local(line, unit_m, {evaluation.origin_m}), by_id)};
    if (is_moved(evaluation)) judged.moved_m = -evaluation.shift->shift_m;
    add_values(fields, first, feature.values, judged);
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

io::MapLayer planes_layer(const std::vector<JudgedPlane>& planes, const ToMap& to_map) {
  io::MapLayer layer{.name = "planes",
                     .description = "LIDAR planes used for judging",
                     .geometry = io::MapGeometry::kPolygon,
                     .columns = columns_of(plane_fields()),
                     .features = {},
                     .style = planes_style()};
  for (const JudgedPlane& plane : planes) {
    io::MapFeature feature;
    std::ranges::transform(plane.outline, std::back_inserter(feature.vertices), to_map);
    add_values(plane_fields(), 0, feature.values, plane);
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

io::MapLayer vectors_layer(const io::LineSet& set,
                           const evaluate::Evaluation& evaluation,
                           const Eigen::Vector3d& unit_m,
                           const ToMap& to_map) {
  io::MapLayer layer{.name = "vectors",
                     .description = "From the middle of a line to its foot points on its planes",
                     .geometry = io::MapGeometry::kLine,
                     .columns = columns_of(vector_fields()),
                     .features = {},
                     .style = vectors_style()};
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const LineEvaluation& e = evaluation.lines[i];
    for (const JudgingPlane& p : e.planes) {
      const Eigen::Vector3d middle = midpoint(set.lines[i].segment_in_world);
      const Eigen::Vector3d x = middle.cwiseProduct(unit_m) - evaluation.origin_m;
      io::MapFeature feature;
      feature.vertices = {middle, to_map(p.plane.projection(x))};
      add_values(vector_fields(), 0, feature.values, e, p);
      layer.features.push_back(std::move(feature));
    }
  }
  return layer;
}

}  // namespace

std::string map_name(const std::string& method) { return fmt::format("judged.{}.gpkg", method); }

MapSchema map_schema_named(const std::string& name) {
  check(name == "plain" || name == "fkb", "schema = ", name, ", must be plain or fkb");
  return name == "fkb" ? MapSchema::kFkb : MapSchema::kPlain;
}

std::string left_out_of_map(const io::LineSet& set) {
  const std::size_t n = set.features.columns.size();
  if (n <= kMaxInputColumns) return "";
  return fmt::format("the map can only hold the first {} of its {} columns", kMaxInputColumns, n);
}

void write_judged_map(const std::string& path,
                      const JudgedFiles& judged,
                      std::size_t i,
                      MapSchema schema) {
  const io::LineSet& set = judged.line_sets[i];
  const evaluate::Evaluation& evaluation = judged.evaluations[i];
  const Eigen::Vector3d unit_m = unit_m_of(set);
  const ToMap to_map(evaluation.origin_m, unit_m);
  std::vector<io::MapLayer> layers{planes_layer(judged.planes[i], to_map)};
  if (i < judged.models.size() && judged.models[i])
    std::ranges::move(model_layers(*judged.models[i], set.features, to_map),
                      std::back_inserter(layers));
  layers.push_back(lines_layer(set, evaluation, judged.planes[i], schema));
  layers.push_back(vectors_layer(set, evaluation, unit_m, to_map));
  layers.push_back(to_fix_layer(to_fix(judged, i), to_map));
  if (evaluation.completeness) layers.push_back(missing_layer(*evaluation.completeness, to_map));
  const bool compared = i < judged.models.size() && judged.models[i].has_value() &&
                        judged.models[i]->missing_roofs.has_value();
  if (compared) layers.push_back(missing_roofs_layer(*judged.models[i]->missing_roofs, to_map));
  io::write_geopackage(path, set.crs.known() ? set.crs : judged.cloud_crs, layers);
}

}  // namespace ridgeline::results
