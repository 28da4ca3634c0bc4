// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/feature_collector.h"

#include "io/lines/model_edges.h"
#include "reconstruct/geometry/faces/face_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

bool is_finite_chain(const Vertices& vertices) {
  return std::ranges::all_of(vertices, [](const auto& x) { return x.allFinite(); });
}

/// The edges of polygons that have not been added before, in either direction.
class NewEdges {
 public:
  std::vector<Vertices> of(const std::vector<std::vector<Vertices>>& polygons) {
    std::vector<Vertices> edges;
    for (const std::vector<Vertices>& rings : polygons)
      for (const Vertices& ring : rings) add(ring, edges);
    return edges;
  }

 private:
  using Cell = std::array<double, 3>;

  /// The rounded position of a corner, because neighbours state a common corner with different last
  /// digits.
  static Cell cell_of(const Eigen::Vector3d& x) {
    constexpr double kPerUnit = 1000.0;
    return {std::round(x.x() * kPerUnit), std::round(x.y() * kPerUnit),
            std::round(x.z() * kPerUnit)};
  }

  void add(const Vertices& ring, std::vector<Vertices>& edges) {
    const Vertices corners = bends_of(ring);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (is_new(corners[i - 1], corners[i])) edges.push_back({corners[i - 1], corners[i]});
    }
  }

  bool is_new(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    std::pair edge(cell_of(start), cell_of(end));
    if (edge.second < edge.first) std::swap(edge.first, edge.second);
    return edge.first != edge.second && known_.insert(edge).second;
  }

  std::set<std::pair<Cell, Cell>> known_;
};

/// Rings of vector files repeat their first vertex.
Face face_of(const std::vector<Vertices>& rings) {
  Face face;
  for (const Vertices& ring : rings) {
    const bool is_closed = ring.size() > 1 && ring.front() == ring.back();
    face.rings.emplace_back(ring.begin(), ring.end() - (is_closed ? 1 : 0));
  }
  return face;
}

/// The building id from our own column, from those of 3DBAG and GML, or from the id of the feature.
std::string building_id(const Line& stated, const Feature& feature) {
  if (!stated.building.empty()) return stated.building;
  for (const char* const name : {"identificatie", "gml_id"}) {
    const auto found =
        feature.properties.is_object() ? feature.properties.find(name) : feature.properties.end();
    if (found != feature.properties.end() && !found->is_null()) return text_of(*found);
  }
  if (!stated.id.empty()) return stated.id;
  return feature.id.empty() ? std::to_string(feature.fid) : feature.id;
}

}  // namespace

void FeatureGeometry::add_polygon(std::vector<Vertices> polygon_rings) {
  if (polygon_rings.empty() || !std::ranges::all_of(polygon_rings, is_finite_chain)) {
    return others.add(kinds::kFlatPolygon);
  }
  polygons.push_back(std::move(polygon_rings));
}

void FeatureCollector::add(Feature feature) {
  const FeatureGeometry& geometry = feature.geometry;
  set_.left_out.add(geometry.others);
  if (!geometry.may_be_line()) return;
  if (!geometry.has_lines() && !geometry.polygons.empty()) {
    surfaces_.push_back(std::move(feature));
    return;
  }
  set_.left_out.add(kinds::kPolygon, geometry.polygons.size());
  has_3d_lines_ = has_3d_lines_ || std::ranges::any_of(geometry.lines, [](const Vertices& line) {
                    return !line.empty() && is_finite_chain(line);
                  });
  append(feature, geometry.lines);
}

void FeatureCollector::append(const Feature& feature, const std::vector<Vertices>& lines) {
  Line attributes = attributes_.line_of(feature.properties, feature.where);
  attributes.layer = feature.layer;
  if (attributes.id.empty()) attributes.id = feature.id;
  append_feature(attributes, lines, feature.fid, set_,
                 feature.values ? feature.values() : SparseRow());
}

void FeatureCollector::finish() {
  if (takes_polygons()) {
    holds_buildings() ? append_buildings() : append_edges();
  } else {
    for (const Feature& surface : surfaces_) {
      set_.left_out.add(kinds::kPolygon, surface.geometry.polygons.size());
    }
  }
  attributes_.finish(set_);
  settle_types(set_.features);
}

bool FeatureCollector::holds_buildings() const {
  return std::ranges::any_of(surfaces_, [](const Feature& surface) {
    const auto& polygons = surface.geometry.polygons;
    return polygons.size() > 1 && std::ranges::any_of(polygons, [](const auto& rings) {
             const auto plane = plane_of(face_of(rings));
             return plane && is_wall(*plane);
           });
  });
}

void FeatureCollector::append_buildings() {
  BuildingModel model;
  model.path = set_.path;
  model.format = set_.format;
  for (const Feature& surface : surfaces_) {
    const Line stated = attributes_.line_of(surface.properties, surface.where);
    model.buildings.push_back({building_id(stated, surface), ""});
    set_.features.rows.push_back(surface.values ? surface.values() : SparseRow());
    require_room(set_, model.faces.size() + surface.geometry.polygons.size());
    for (const std::vector<Vertices>& rings : surface.geometry.polygons) {
      model.faces.push_back(face_of(rings));
      model.faces.back().building = model.buildings.size() - 1;
    }
  }
  model.attributes = std::move(set_.features);
  LineSet lines = lines_of_model(std::move(model));
  set_.format = std::move(lines.format);
  set_.lines = std::move(lines.lines);
  set_.features = std::move(lines.features);
  set_.left_out.add(lines.left_out);
  set_.model = std::move(lines.model);
}

void FeatureCollector::append_edges() {
  NewEdges new_edges;
  std::size_t n_polygons = 0;
  std::size_t n_edges = 0;
  for (const Feature& surface : surfaces_) {
    n_polygons += surface.geometry.polygons.size();
    const std::vector<Vertices> edges = new_edges.of(surface.geometry.polygons);
    n_edges += edges.size();
    if (edges.empty()) continue;
    append(surface, edges);
  }
  set_.format += ", edges of polygons";
  set_.warnings.push_back(
      fmt::format("has polygons but no 3D lines: reading the {} edges of {} polygons with heights; "
                  "shared edges are read once",
                  n_edges, n_polygons));
}

}  // namespace ridgeline::io
