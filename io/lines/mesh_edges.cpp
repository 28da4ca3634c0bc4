// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/mesh_edges.h"

#include "io/lines/model_edges.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

using Coordinates = std::array<double, 3>;

Coordinates coordinates_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

void append_distinct_edges(const Vertices& vertices,
                           const std::vector<IndexList>& polygons,
                           LineSet& set) {
  std::set<std::pair<Coordinates, Coordinates>> known;
  std::size_t number = 0;
  for (const IndexList& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector3d& start = vertices[polygon[i]];
      const Eigen::Vector3d& end = vertices[polygon[(i + 1) % polygon.size()]];
      // NaN cannot be ordered, so an edge with NaN is always kept.
      const bool finite = start.allFinite() && end.allFinite();
      if (finite && start == end) continue;
      std::pair edge(coordinates_of(start), coordinates_of(end));
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
      if (finite && !known.insert(edge).second) continue;
      append_segment({}, {start, end}, number++, set);
    }
  }
}

/// The polygons as faces of one building.
BuildingModel model_of(const PolygonMesh& mesh) {
  BuildingModel model;
  for (const IndexList& polygon : mesh.polygons) {
    const auto place_of = [&](std::size_t i) { return mesh.vertices[i]; };
    model.faces.push_back({{transformed(polygon, place_of)}, FaceKind::kUnknown, 0, ""});
  }
  return model;
}

bool has_walls(const BuildingModel& model) {
  return std::ranges::any_of(model.faces, [](const Face& face) {
    const auto plane = plane_of(face);
    return plane && is_wall(*plane);
  });
}

}  // namespace

void append_mesh(const PolygonMesh& mesh, LineSet& set) {
  BuildingModel model = model_of(mesh);
  if (!has_walls(model)) {
    set.format += ", edges of faces";
    return append_distinct_edges(mesh.vertices, mesh.polygons, set);
  }
  require_room(set, model.faces.size());
  divide_into_buildings(mesh.names, model);
  model.path = set.path;
  model.format = set.format;
  set = lines_of_model(std::move(model));
}

}  // namespace ridgeline::io
