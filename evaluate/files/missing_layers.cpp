// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/missing_layers.h"

#include "evaluate/files/map_style.h"
#include "reconstruct/geometry/transformed.h"

namespace ridgeline::results {
namespace {

using evaluate::ExpectedEdge;
using io::ColumnType;

const std::vector<MapField<ExpectedEdge>>& missing_fields() {
  static const std::vector<MapField<ExpectedEdge>> fields{
      {"kind", ColumnType::kText, [](const auto& e) { return text(e.kind); }},
      {"length_m", ColumnType::kReal, [](const auto& e) { return number(e.length_m); }},
      {"support", ColumnType::kReal, [](const auto& e) { return number(e.support); }},
      {"covered_share", ColumnType::kReal, [](const auto& e) { return number(e.covered); }}};
  return fields;
}

const std::vector<MapField<MissingRoof>>& missing_roof_fields() {
  static const std::vector<MapField<MissingRoof>> fields{
      {"area_m2", ColumnType::kReal, [](const auto& r) { return number(r.area_m2); }},
      {"explained_share", ColumnType::kReal, [](const auto& r) { return number(r.explained); }}};
  return fields;
}

}  // namespace

io::MapLayer missing_layer(const evaluate::Completeness& completeness, const ToMap& to_map) {
  io::MapLayer layer{.name = "missing",
                     .description = "Edges of the scan that the lines do not show",
                     .geometry = io::MapGeometry::kLine,
                     .columns = columns_of(missing_fields()),
                     .features = {},
                     .style = missing_style()};
  for (const ExpectedEdge& edge : completeness.edges) {
    if (edge.is_found() || !edge.is_shown) continue;
    io::MapFeature& feature = layer.features.emplace_back();
    feature.vertices = {to_map(edge.segment.start), to_map(edge.segment.end)};
    add_values(missing_fields(), 0, feature.values, edge);
  }
  return layer;
}

io::MapLayer missing_roofs_layer(const std::vector<MissingRoof>& roofs, const ToMap& to_map) {
  io::MapLayer layer{.name = "missing_roofs",
                     .description = "Roofs of the scan without a building of the model",
                     .geometry = io::MapGeometry::kMultiPolygon,
                     .columns = columns_of(missing_roof_fields()),
                     .features = {},
                     .style = missing_roofs_style()};
  for (const MissingRoof& roof : roofs) {
    io::MapFeature& feature = layer.features.emplace_back();
    feature.polygons = {transformed(roof.rings, [&](const std::vector<Eigen::Vector3d>& ring) {
      return transformed(ring, to_map);
    })};
    add_values(missing_roof_fields(), 0, feature.values, roof);
  }
  return layer;
}

}  // namespace ridgeline::results
