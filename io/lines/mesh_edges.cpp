// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/mesh_edges.h"

#include "io/lines/model_edges.h"
#include "io/models/face_roles.h"
#include "io/models/face_seams.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
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
      // A NaN has no place in an order: such an edge is kept, whatever came before.
      const bool finite = start.allFinite() && end.allFinite();
      if (finite && start == end) continue;
      std::pair edge(coordinates_of(start), coordinates_of(end));
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
      if (finite && !known.insert(edge).second) continue;
      append_segment({}, {start, end}, number++, set);
    }
  }
}

/// The polygons as faces of one building; those that are none lose their objects as well.
BuildingModel model_of(Mesh& mesh) {
  BuildingModel model;
  const bool has_objects = mesh.objects.size() == mesh.polygons.size();
  std::vector<std::string> objects;
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const IndexList& polygon = mesh.polygons[i];
    Ring ring = transformed(polygon, [&](std::size_t k) { return mesh.vertices[k]; });
    if (ring.size() < 3) {
      model.left_out.add({"face of two vertices", "faces of two vertices"});
      continue;
    }
    model.faces.push_back({{std::move(ring)}, SurfaceKind::kUnknown, 0, ""});
    if (has_objects) objects.push_back(mesh.objects[i]);
  }
  mesh.objects = std::move(objects);
  return model;
}

/// The lowest number of the faces that a face hangs together with, for each face.
std::vector<std::size_t> connected_faces(const std::vector<ModelFace>& faces) {
  std::vector<std::size_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const FaceSeam& seam : seams_of(faces)) {
    for (const std::size_t face : seam.faces) {
      const std::size_t a = root(seam.faces[0]), b = root(face);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::size_t> lowest;
  for (std::size_t i = 0; i < faces.size(); ++i) lowest.push_back(root(i));
  return lowest;
}

/// Gives each face its building, and puts the faces of a building together.
void divide(const Mesh& mesh, BuildingModel& model) {
  const bool has_objects = mesh.objects.size() == model.faces.size();
  const std::vector<std::size_t> connected =
      has_objects ? std::vector<std::size_t>() : connected_faces(model.faces);
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const std::string key = has_objects ? mesh.objects[i] : std::to_string(connected[i]);
    const auto [entry, is_new] = numbers.try_emplace(key, model.buildings.size());
    if (is_new) model.buildings.push_back({has_objects ? key : std::to_string(numbers.size()), ""});
    model.faces[i].building = entry->second;
  }
  std::ranges::stable_sort(model.faces, {}, &ModelFace::building);
  model.attributes.rows.resize(model.buildings.size());
}

bool has_walls(const BuildingModel& model) {
  return std::ranges::any_of(model.faces, [](const ModelFace& face) {
    const auto plane = plane_of(face);
    return plane && is_wall(*plane);
  });
}

}  // namespace

void append_mesh(Mesh mesh, LineSet& set) {
  BuildingModel model = model_of(mesh);
  if (!has_walls(model)) {
    set.format += ", edges of faces";
    return append_distinct_edges(mesh.vertices, mesh.polygons, set);
  }
  refuse_more_lines(set, model.faces.size());
  divide(mesh, model);
  model.path = set.path;
  model.format = set.format;
  set = lines_of_model(std::move(model));
}

}  // namespace ridgeline::io
