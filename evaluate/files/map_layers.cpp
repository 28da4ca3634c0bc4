// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/map_layers.h"

#include "evaluate/files/map_style.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace ridgeline::results {
namespace {

using evaluate::BuildingRow;
using evaluate::FaceEvaluation;
using io::ColumnType;
using io::Value;

using BuildingField = MapField<BuildingRow>;

std::optional<double> shift_along(const BuildingRow& building, int axis) {
  return building.shift_m ? std::optional((*building.shift_m)[axis]) : std::nullopt;
}

const std::vector<BuildingField>& building_fields() {
  static const std::vector<BuildingField> fields{
      {"building", ColumnType::kText, [](const auto& b) { return text(b.id); }},
      {"verdict", ColumnType::kText, [](const auto& b) { return text(evaluate::text(b.verdict)); }},
      {"n_lines", ColumnType::kInteger, [](const auto& b) { return integer(b.n_lines); }},
      {"n_judged_lines", ColumnType::kInteger,
       [](const auto& b) { return integer(b.n_judged_lines); }},
      {"rms_m", ColumnType::kReal, [](const auto& b) { return number(b.rms_m); }},
      {"worst_line", ColumnType::kText, [](const auto& b) { return text(b.worst_line); }},
      {"worst_distance_m", ColumnType::kReal,
       [](const auto& b) { return number(b.worst_distance_m); }},
      {"n_faces", ColumnType::kInteger, [](const auto& b) { return integer(b.n_faces); }},
      {"n_judged_faces", ColumnType::kInteger,
       [](const auto& b) { return integer(b.n_judged_faces); }},
      {"area_m2", ColumnType::kReal, [](const auto& b) { return number(b.area_m2); }},
      {"wrong_height_share", ColumnType::kReal,
       [](const auto& b) { return number(b.wrong_height); }},
      {"wrong_tilt_share", ColumnType::kReal, [](const auto& b) { return number(b.wrong_tilt); }},
      {"wrong_outline_share", ColumnType::kReal,
       [](const auto& b) { return number(b.wrong_outline); }},
      {"ridge_height_m", ColumnType::kReal,
       [](const auto& b) { return number(b.heights.ridge_m); }},
      {"eave_height_m", ColumnType::kReal, [](const auto& b) { return number(b.heights.eave_m); }},
      {"unexplained_share", ColumnType::kReal, [](const auto& b) { return number(b.unexplained); }},
      {"shift_x_m", ColumnType::kReal, [](const auto& b) { return number(shift_along(b, 0)); }},
      {"shift_y_m", ColumnType::kReal, [](const auto& b) { return number(shift_along(b, 1)); }},
      {"shift_z_m", ColumnType::kReal, [](const auto& b) { return number(shift_along(b, 2)); }},
      {"points_rms_m", ColumnType::kReal, [](const auto& b) { return number(b.points_rms_m); }},
      {"points_p90_m", ColumnType::kReal, [](const auto& b) { return number(b.points_p90_m); }},
      {"roof_points_rms_m", ColumnType::kReal,
       [](const auto& b) { return number(b.roof_points_rms_m); }},
      {"covered_share", ColumnType::kReal, [](const auto& b) { return number(b.covered); }}};
  return fields;
}

/// A figure of a face; empty if the face was not judged.
template <typename Get>
Value if_judged(const FaceEvaluation& face, Get get) {
  return face.status == evaluate::FaceStatus::kEvaluated ? number(get(face.difference)) : Value();
}

std::optional<double> value_of(const std::optional<evaluate::Estimate>& estimate) {
  return estimate ? std::optional(estimate->value) : std::nullopt;
}

using FaceField = MapField<FaceEvaluation>;

const std::vector<FaceField>& face_fields() {
  static const std::vector<FaceField> fields{
      {"face", ColumnType::kText, [](const auto& f) { return text(f.id); }},
      {"status", ColumnType::kText, [](const auto& f) { return text(name(f.status)); }},
      {"verdict", ColumnType::kText,
       [](const auto& f) {
         const bool is_judged = f.status == evaluate::FaceStatus::kEvaluated;
         return is_judged ? text(evaluate::text(f.verdict)) : Value();
       }},
      {"area_m2", ColumnType::kReal, [](const auto& f) { return number(f.area_m2); }},
      {"n_points", ColumnType::kInteger, [](const auto& f) { return integer(f.n_over); }},
      {"shift_m", ColumnType::kReal,
       [](const auto& f) {
         return if_judged(f, [](const auto& d) { return std::optional(d.shift_m.value); });
       }},
      {"shift_95_m", ColumnType::kReal,
       [](const auto& f) {
         return if_judged(f, [](const auto& d) { return std::optional(d.shift_m.half_width); });
       }},
      {"height_m", ColumnType::kReal,
       [](const auto& f) {
         return if_judged(f, [](const auto& d) { return std::optional(d.height_m.value); });
       }},
      {"pitch_deg", ColumnType::kReal,
       [](const auto& f) {
         return if_judged(f, [](const auto& d) { return value_of(d.pitch_deg); });
       }},
      {"aspect_deg", ColumnType::kReal,
       [](const auto& f) {
         return if_judged(f, [](const auto& d) { return value_of(d.aspect_deg); });
       }},
      {"missing_m2", ColumnType::kReal, [](const auto& f) { return number(f.missing_m2); }},
      {"beyond_m2", ColumnType::kReal, [](const auto& f) { return number(f.beyond_m2); }}};
  return fields;
}

using Polygon = std::vector<std::vector<Eigen::Vector3d>>;

Polygon polygon_of(const evaluate::RoofFace& face, const ToMap& to_map) {
  Polygon polygon;
  for (const std::vector<Eigen::Vector3d>& ring : face.rings)
    polygon.push_back(transformed(ring, to_map));
  return polygon;
}

io::MapLayer buildings_layer(const JudgedModel& judged,
                             const io::AttributeTable& attributes,
                             const ToMap& to_map) {
  io::MapLayer layer{.name = "buildings",
                     .description = "Buildings with the figures of their lines and roof faces",
                     .geometry = io::MapGeometry::kMultiPolygon,
                     .columns = renamed(attributes.columns, columns_of(building_fields())),
                     .features = {},
                     .style = buildings_style()};
  const std::size_t first = layer.columns.size();
  std::ranges::move(columns_of(building_fields()), std::back_inserter(layer.columns));
  for (std::size_t i = 0; i < judged.buildings.size(); ++i) {
    io::MapFeature feature;
    if (judged.places[i] < attributes.rows.size())
      feature.values = attributes.rows[judged.places[i]];
    for (const evaluate::RoofFace& face : judged.buildings[i].faces)
      feature.polygons.push_back(polygon_of(face, to_map));
    add_values(building_fields(), first, feature.values, judged.rows[i]);
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

io::MapLayer faces_layer(const JudgedModel& judged, const ToMap& to_map) {
  io::MapLayer layer{.name = "faces",
                     .description = "Roof faces with their differences from the LIDAR points",
                     .geometry = io::MapGeometry::kMultiPolygon,
                     .columns = {{"building", ColumnType::kText}},
                     .features = {},
                     .style = faces_style()};
  std::ranges::move(columns_of(face_fields()), std::back_inserter(layer.columns));
  for (std::size_t i = 0; i < judged.buildings.size(); ++i) {
    for (std::size_t k = 0; k < judged.faces[i].size(); ++k) {
      io::MapFeature feature;
      feature.polygons = {polygon_of(judged.buildings[i].faces[k], to_map)};
      feature.values.emplace_back(0, text(judged.buildings[i].id));
      add_values(face_fields(), 1, feature.values, judged.faces[i][k]);
      layer.features.push_back(std::move(feature));
    }
  }
  return layer;
}

}  // namespace

std::vector<io::Column> renamed(std::vector<io::Column> columns,
                                const std::vector<io::Column>& ours) {
  std::set<std::string> taken{"fid", "geom"};
  for (const io::Column& column : ours) taken.insert(io::lower_case(column.name));
  for (io::Column& column : columns) {
    if (column.name.empty()) column.name = "column";
    const std::string name = column.name;
    for (int n = 1; !taken.insert(io::lower_case(column.name)).second; ++n) {
      column.name = n == 1 ? name + "_in" : fmt::format("{}_in{}", name, n);
    }
  }
  return columns;
}

std::optional<double> aspect_deg(const Plane3& plane) {
  const Eigen::Vector3d n = plane.normal();
  if (n.x() == 0.0 && n.y() == 0.0) return std::nullopt;
  const double azimuth_deg = deg_from_rad(std::atan2(n.x(), n.y()));
  return azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg;
}

std::vector<io::Column> building_columns() { return columns_of(building_fields()); }

io::SparseRow building_values(const BuildingRow& row, std::size_t first) {
  io::SparseRow values;
  add_values(building_fields(), first, values, row);
  return values;
}

std::vector<io::MapLayer> model_layers(const JudgedModel& judged,
                                       const io::AttributeTable& attributes,
                                       const ToMap& to_map) {
  return {buildings_layer(judged, attributes, to_map), faces_layer(judged, to_map)};
}

}  // namespace ridgeline::results
