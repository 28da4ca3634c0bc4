// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/model_edges.h"

#include "io/lines/polyline.h"
#include "io/models/face_roles.h"
#include "io/models/face_seams.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kLevel_rad = 5.0 * kRadians;  // as the judge's roof_kind()

constexpr Kind kCrowdedEdge{"edge of three roof faces or more",
                            "edges of three roof faces or more"};
constexpr Kind kFlatFace{"face without an area", "faces without an area"};

double rise_rad(const Segment3& s) {
  const Eigen::Vector3d d = s.end - s.start;
  return std::atan2(std::abs(d.z()), d.head<2>().norm());
}

/// The faces of one building with what they are.
struct BuildingFaces {
  std::span<const ModelFace> faces;
  std::vector<std::optional<Plane3>> planes;
  std::vector<SurfaceKind> roles;

  explicit BuildingFaces(std::span<const ModelFace> of_building)
      : faces(of_building),
        planes(transformed(of_building, plane_of)),
        roles(roles_of(of_building, planes)) {}

  [[nodiscard]] Plane3 roof(std::size_t i) const { return upward(*planes[i]); }

  [[nodiscard]] std::optional<Eigen::Vector3d> inward(std::size_t i, const Segment3& edge) const {
    return inward_of(faces[i], *planes[i], edge);
  }

  /// The angle between two faces.
  [[nodiscard]] double angle_rad(std::size_t a, std::size_t b) const {
    const Eigen::Vector3d n = roof(a).normal(), m = roof(b).normal();
    return std::atan2(n.cross(m).norm(), n.dot(m));
  }
};

std::string kind_of_border(const Plane3& roof, const Segment3& edge) {
  if (slope_rad(roof) < kLevel_rad) return "step";
  const Eigen::Vector2d down = roof.normal().head<2>().normalized();
  const Eigen::Vector2d along = (edge.end - edge.start).head<2>().normalized();
  return std::abs(down.dot(along)) < std::numbers::sqrt2 / 2.0 ? "eave" : "verge";
}

/// The edge of two roof faces.
std::string kind_of_fold(const BuildingFaces& building,
                         std::size_t a,
                         std::size_t b,
                         const Segment3& edge) {
  const auto inward_a = building.inward(a, edge);
  const auto inward_b = building.inward(b, edge);
  const double above = (inward_a ? building.roof(b).normal().dot(*inward_a) : 0.0) +
                       (inward_b ? building.roof(a).normal().dot(*inward_b) : 0.0);
  if (above > 0.0) return "valley";
  return rise_rad(edge) < kLevel_rad ? "ridge" : "hip";
}

/// For each face the lowest number of the faces that lie in one plane with it: parts of a face that a file has in triangles or with
/// borders within. They have one role and meet along an edge.
std::vector<std::size_t> regions_of(const BuildingFaces& building) {
  constexpr double kFlat_rad =
      0.5 * kRadians;  // coordinates in whole mm turn a face of 0.2 m by that
  std::vector<std::size_t> parent(building.faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const FaceSeam& seam : seams_of(building.faces)) {
    if (seam.faces.size() != 2) continue;
    const std::size_t a = seam.faces[0], b = seam.faces[1];
    const bool is_one = building.planes[a] && building.planes[b] &&
                        building.roles[a] == building.roles[b] &&
                        building.angle_rad(a, b) < kFlat_rad;
    if (is_one) parent[std::max(root(a), root(b))] = std::min(root(a), root(b));
  }
  std::vector<std::size_t> regions;
  for (std::size_t i = 0; i < parent.size(); ++i) regions.push_back(root(i));
  return regions;
}

class EdgesOfBuilding {
 public:
  EdgesOfBuilding(std::span<const ModelFace> faces, const ModelEdgeOptions& options)
      : building_(faces), options_(options) {}

  void append(const Line& attributes, std::size_t first_face, LineSet& set) {
    for (const std::optional<Plane3>& plane : building_.planes)
      set.left_out.add(kFlatFace, plane ? 0 : 1);
    std::size_t number = 0;
    for (const FaceSeam& seam : seams_of(building_.faces, regions_of(building_))) {
      const std::string kind = kind_of(seam, set.left_out);
      if (kind.empty()) continue;
      Line line = attributes;
      line.id = fmt::format("{}.{}", attributes.building, number++);
      line.kind = kind;
      line.segment_in_world = seam.segment;
      for (const std::size_t face : roofs_of(seam))
        line.plane_ids.push_back(static_cast<int>(first_face + face));
      set.lines.push_back(std::move(line));
    }
  }

 private:
  [[nodiscard]] std::vector<std::size_t> roofs_of(const FaceSeam& seam) const {
    return with_role(seam, SurfaceKind::kRoof);
  }

  [[nodiscard]] std::vector<std::size_t> with_role(const FaceSeam& seam, SurfaceKind role) const {
    std::vector<std::size_t> found;
    for (const std::size_t face : seam.faces)
      if (building_.roles[face] == role && building_.planes[face]) found.push_back(face);
    return found;
  }

  /// Empty for an edge that is no line.
  [[nodiscard]] std::string kind_of(const FaceSeam& seam, KindCounts& left_out) const {
    const std::vector<std::size_t> roofs = roofs_of(seam);
    if (roofs.empty()) return "";
    if (roofs.size() > 2) left_out.add(kCrowdedEdge);
    if (roofs.size() > 2) return "";
    if (roofs.size() == 1) return kind_of_border_of(seam, roofs[0]);
    const bool is_flat =
        building_.angle_rad(roofs[0], roofs[1]) < options_.least_angle_deg * kRadians;
    if (is_flat) return "";
    return kind_of_fold(building_, roofs[0], roofs[1], seam.part);
  }

  [[nodiscard]] std::string kind_of_border_of(const FaceSeam& seam, std::size_t roof) const {
    const std::vector<std::size_t> walls = with_role(seam, SurfaceKind::kWall);
    const bool is_foot = std::ranges::any_of(walls, [&](std::size_t wall) {
      const auto way = building_.inward(wall, seam.part);
      return way && way->z() > 0.0;
    });
    return is_foot ? "step" : kind_of_border(building_.roof(roof), seam.segment);
  }

  BuildingFaces building_;
  const ModelEdgeOptions& options_;
};

/// Leaves one of the faces of a building with the same outline, as a solid and a multi-surface of one level have: the first that
/// states what it is.
void drop_repeats(BuildingModel& model, KindCounts& left_out) {
  using Outline = std::vector<std::array<double, 3>>;
  std::map<std::pair<std::size_t, Outline>, std::size_t> kept_at;
  std::vector<ModelFace> kept;
  for (ModelFace& face : model.faces) {
    Outline outline;
    for (const Eigen::Vector3d& x : face.rings.front())
      outline.push_back(
          {std::round(1000.0 * x.x()), std::round(1000.0 * x.y()), std::round(1000.0 * x.z())});
    std::ranges::sort(outline);
    const bool is_usable = std::ranges::all_of(
        face.rings.front(), [](const Eigen::Vector3d& x) { return x.allFinite(); });
    const auto [entry, is_new] =
        is_usable ? kept_at.try_emplace({face.building, std::move(outline)}, kept.size())
                  : std::pair(kept_at.end(), true);
    if (is_new) {
      kept.push_back(std::move(face));
      continue;
    }
    left_out.add({"repeated face", "repeated faces"});
    ModelFace& first = kept[entry->second];
    if (first.kind == SurfaceKind::kUnknown) first = std::move(face);
  }
  model.faces = std::move(kept);
}

/// Lines and tables name buildings by their ids.
void make_building_ids_unique(std::vector<Building>& buildings,
                              std::vector<std::string>& warnings) {
  std::map<std::string, int> n_taken;  // how often an id was asked for
  std::size_t n_renamed = 0;
  for (Building& building : buildings) {
    const std::string id = building.id;
    int& n = n_taken[id];
    n_renamed += n > 0 ? 1 : 0;
    while (n > 0 && n_taken.contains(building.id)) building.id = fmt::format("{}_{}", id, n++);
    n = std::max(n, 1);
    n_taken.try_emplace(building.id, 1);
  }
  if (n_renamed > 0) {
    warnings.push_back(
        fmt::format("{} building{} the id of an earlier one, and \"_1\", \"_2\", ... behind it",
                    n_renamed, n_renamed == 1 ? " has" : "s have"));
  }
}

}  // namespace

LineSet lines_of_model(BuildingModel model, const ModelEdgeOptions& options) {
  LineSet set;
  set.path = model.path;
  set.format = model.format + ", edges of roofs";
  set.crs = model.crs;
  set.features = std::exchange(model.attributes, {});
  set.left_out = model.left_out;
  set.warnings = model.warnings;
  std::ranges::stable_sort(model.faces, {}, &ModelFace::building);
  make_building_ids_unique(model.buildings, set.warnings);
  drop_repeats(model, set.left_out);
  const std::span<const ModelFace> faces = model.faces;
  for (std::size_t first = 0; first < faces.size();) {
    const std::size_t building = faces[first].building;
    std::size_t last = first;
    while (last < faces.size() && faces[last].building == building) ++last;
    Line attributes;
    attributes.building = model.buildings[building].id;
    attributes.row = building;
    attributes.source_fid = static_cast<std::int64_t>(building);
    EdgesOfBuilding(faces.subspan(first, last - first), options).append(attributes, first, set);
    first = last;
  }
  set.model = std::make_shared<const BuildingModel>(std::move(model));
  return set;
}

}  // namespace ridgeline::io
