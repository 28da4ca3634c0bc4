// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_lines.h"

#include "evaluate/faces/plan_polygon.h"
#include "evaluate/files/map_layers.h"
#include "evaluate/files/map_style.h"
#include "evaluate/scan/edge_kinds.h"
#include "io/lines/attributes.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::ScanEdge;
using evaluate::ScanPlane;
using io::ColumnType;
using Ring = std::vector<Eigen::Vector3d>;

/// An edge and its line.
struct EdgeLine {
  const ScanEdge& edge;
  const io::Line& line;
};

const std::vector<MapField<EdgeLine>>& scan_edge_fields() {
  static const std::vector<MapField<EdgeLine>> fields{
      {"id", ColumnType::kText, [](const auto& e) { return text(e.line.id); }},
      {"kind", ColumnType::kText, [](const auto& e) { return text(e.line.kind); }},
      {"length_m", ColumnType::kReal, [](const auto& e) { return number(length(e.edge.segment)); }},
      {"support", ColumnType::kReal, [](const auto& e) { return number(e.line.support); }},
      {"moved_out_m", ColumnType::kReal, [](const auto& e) { return number(e.line.moved_out_m); }},
      {"sigma_m", ColumnType::kReal, [](const auto& e) { return number(across_sigma_m(e.edge)); }},
      {"plane_ids", ColumnType::kText,
       [](const auto& e) { return text(fmt::format("[{}]", fmt::join(e.line.plane_ids, ","))); }},
      {"covariance", ColumnType::kText,
       [](const auto& e) { return text(io::covariance_text(*e.line.covariance_m2)); }}};
  return fields;
}

struct NumberedPlane {
  const ScanPlane& plane;
  std::size_t id;
};

const std::vector<MapField<NumberedPlane>>& scan_plane_fields() {
  static const std::vector<MapField<NumberedPlane>> fields{
      {"plane_id", ColumnType::kInteger64,
       [](const auto& p) { return integer(static_cast<std::int64_t>(p.id)); }},
      {"slope_deg", ColumnType::kReal,
       [](const auto& p) { return number(deg_from_rad(slope_rad(p.plane.fit.plane))); }},
      {"aspect_deg", ColumnType::kReal,
       [](const auto& p) { return number(aspect_deg(p.plane.fit.plane)); }},
      {"area_m2", ColumnType::kReal, [](const auto& p) { return number(p.plane.area_m2); }},
      {"sigma_m", ColumnType::kReal, [](const auto& p) { return number(p.plane.fit.sigma0_m); }},
      {"n_points", ColumnType::kInteger, [](const auto& p) { return integer(p.plane.fit.n); }}};
  return fields;
}

/// The polygons of a plane: a ring that lies in none of the outer rings before it is another outer
/// ring.
std::vector<std::vector<Ring>> polygons_of(const ScanPlane& plane, const ToMap& to_map) {
  std::vector<std::vector<Ring>> polygons;
  std::vector<evaluate::PlanPolygon> outer;
  for (const Ring& ring : plane.rings) {
    std::size_t at = 0;
    while (at < outer.size() && !outer[at].contains(ring.front().head<2>())) ++at;
    if (at == outer.size()) {
      outer.emplace_back(std::vector<Ring>{ring});
      polygons.emplace_back();
    }
    polygons[at].push_back(transformed(ring, to_map));
  }
  return polygons;
}

io::MapLayer edges_layer(const evaluate::ScanEdges& edges, const io::LineSet& set) {
  const auto& fields = scan_edge_fields();
  io::MapLayer layer{.name = "lines",
                     .description = "Edges of the roofs of a point cloud",
                     .geometry = io::MapGeometry::kLine,
                     .columns = columns_of(fields),
                     .features = {},
                     .style = edge_kinds_style()};
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const io::Line& line = set.lines[i];
    io::MapFeature& feature = layer.features.emplace_back();
    feature.vertices = {line.segment_in_world.start, line.segment_in_world.end};
    add_values(fields, 0, feature.values, EdgeLine{edges.edges[i], line});
  }
  return layer;
}

io::MapLayer roof_planes_layer(const evaluate::ScanEdges& edges, const ToMap& to_map) {
  const auto& fields = scan_plane_fields();
  io::MapLayer layer{.name = "planes",
                     .description = "Roof planes of a point cloud",
                     .geometry = io::MapGeometry::kMultiPolygon,
                     .columns = columns_of(fields),
                     .features = {},
                     .style = planes_style()};
  for (std::size_t i = 0; i < edges.planes.size(); ++i) {
    if (!edges.planes[i].is_roof) continue;
    io::MapFeature& feature = layer.features.emplace_back();
    feature.polygons = polygons_of(edges.planes[i], to_map);
    add_values(fields, 0, feature.values, NumberedPlane{edges.planes[i], i + 1});
  }
  return layer;
}

}  // namespace

io::LineSet lines_of_scan(const evaluate::ScanEdges& edges, const io::CloudFiles& cloud) {
  const ToMap to_map(cloud.frame().origin_m, cloud.unit_m());
  io::LineSet set;
  set.crs = cloud.crs();
  for (const ScanEdge& edge : edges.edges) {
    io::Line& line = set.lines.emplace_back();
    line.id = fmt::format("{}", set.lines.size());
    line.kind = edge.kind;
    line.segment_in_world = {to_map(edge.segment.start), to_map(edge.segment.end)};
    line.covariance_m2 = edge.covariance_m2;
    line.support = edge.support;
    line.moved_out_m = edge.moved_out_m;
    for (const std::size_t plane : edge.planes) {
      line.plane_ids.push_back(static_cast<int>(plane) + 1);
    }
  }
  return set;
}

void drop_short_edges(double min_length_m, evaluate::ScanEdges& edges) {
  std::erase_if(edges.edges,
                [&](const ScanEdge& edge) { return length(edge.segment) < min_length_m; });
}

void write_scan_edges(const std::string& path,
                      const evaluate::ScanEdges& edges,
                      const io::CloudFiles& cloud,
                      io::LineFormat format,
                      const io::WriteLinesOptions& options) {
  const io::LineSet set = lines_of_scan(edges, cloud);
  if (format != io::LineFormat::kGeoPackage) {
    io::write_lines(path, set, format, options);
    return;
  }
  const ToMap to_map(cloud.frame().origin_m, cloud.unit_m());
  io::write_geopackage(path, set.crs, {roof_planes_layer(edges, to_map), edges_layer(edges, set)});
}

}  // namespace ridgeline::results
