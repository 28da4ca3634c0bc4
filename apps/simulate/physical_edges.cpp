// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/physical_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace ridgeline::simulate {
namespace {

constexpr double kSameLineM = 0.005;  // a sixteenth of a pixel at GSD 8 cm
constexpr double kTouchM = 0.02;
constexpr double kMinEdgeLengthM = 0.02;

const char* kind_of(Material material) {
  switch (material) {
    case Material::kGround:
    case Material::kStreet:
    case Material::kMarking:
    case Material::kPaving:
      return "ground";
    case Material::kGlass:
    case Material::kFrame:
    case Material::kSolar:
      return "fitting";
    case Material::kRoof:
    case Material::kGutter:
      return "gutter";
    case Material::kChimney:
      return "chimney";
    case Material::kWood:
      return "fence";
    case Material::kCar:
      return "car";
    default:
      return "wall";
  }
}

/// The height of the ground below a plan position; undefined outside the plan.
class Ground {
 public:
  explicit Ground(const SyntheticScene& scene) {
    for (const ScenePlane& plane : scene.planes) {
      if (plane.kind != PlaneKind::kGround || plane.outline.empty()) continue;
      ConvexPolygon outline;
      for (const Eigen::Vector3d& x : plane.outline) outline.emplace_back(x.head<2>());
      pieces_.push_back({half_planes(outline), plane.plane});
    }
  }
  [[nodiscard]] std::optional<double> height(const Eigen::Vector2d& x) const {
    for (const VisiblePiece& piece : pieces_) {
      const bool inside = std::all_of(piece.sides.begin(), piece.sides.end(),
                                      [&](const PlanFunction& side) { return side(x) >= 0.0; });
      if (inside) return height_at(piece.plane, x);
    }
    return std::nullopt;
  }

 private:
  struct VisiblePiece {
    std::vector<PlanFunction> sides;
    Plane3 plane;
  };
  std::vector<VisiblePiece> pieces_;
};

/// Raises the lower border of a body to the ground, where it becomes visible.
Segment3 raised_to_ground(Segment3 edge, const Ground& ground) {
  const auto start_z = ground.height(edge.start.head<2>());
  const auto end_z = ground.height(edge.end.head<2>());
  if (!start_z || !end_z || edge.start.z() >= *start_z || edge.end.z() >= *end_z) return edge;
  edge.start.z() = *start_z;
  edge.end.z() = *end_z;
  return edge;
}

/// Adds the borders of the polygons: the sides that belong to only one triangle, because polygons
/// share no vertices.
void add_mesh_edges(const SyntheticScene& scene, std::vector<PhysicalEdge>& edges) {
  const Ground ground(scene);
  std::map<std::pair<int, int>, std::pair<Material, int>> sides;  // -> material, triangles
  for (const Triangle& triangle : scene.mesh.triangles) {
    if (triangle.material == Material::kFoliage) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends = std::minmax(triangle.vertices[i], triangle.vertices[(i + 1) % 3]);
      auto& [material, count] = sides[{ends.first, ends.second}];
      material = triangle.material;
      ++count;
    }
  }
  for (const auto& [ends, side] : sides) {
    const auto& [material, count] = side;
    if (count != 1) continue;
    Segment3 segment{scene.mesh.vertices[static_cast<std::size_t>(ends.first)],
                     scene.mesh.vertices[static_cast<std::size_t>(ends.second)]};
    const bool flat = material == Material::kGround || material == Material::kStreet ||
                      material == Material::kMarking;
    if (!flat) segment = raised_to_ground(segment, ground);
    if (length(segment) < kMinEdgeLengthM) continue;
    edges.push_back({segment, kind_of(material), 2});
  }
}

double distance_to_line(const Segment3& line, const Eigen::Vector3d& x) {
  const Eigen::Vector3d direction = (line.end - line.start).normalized();
  return (x - line.start).cross(direction).norm();
}

/// Whether two edges are collinear and overlap or touch.
bool continue_each_other(const Segment3& a, const Segment3& b) {
  const Segment3& longer = length(a) >= length(b) ? a : b;
  const Segment3& shorter = length(a) >= length(b) ? b : a;
  if (distance_to_line(longer, shorter.start) > kSameLineM) return false;
  if (distance_to_line(longer, shorter.end) > kSameLineM) return false;
  const Eigen::Vector3d direction = (longer.end - longer.start).normalized();
  const double from = direction.dot(shorter.start - longer.start);
  const double to = direction.dot(shorter.end - longer.start);
  return std::max(from, to) >= -kTouchM && std::min(from, to) <= length(longer) + kTouchM;
}

/// Groups of connected edges (disjoint sets).
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t k) {
    const auto [low, high] = std::minmax({root(i), root(k)});
    parent_[high] = low;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Indices of the edges that pass through each cell of a plan grid, so that only neighbours are
/// compared.
std::map<std::pair<int, int>, std::vector<std::size_t>> cells_of(
    const std::vector<PhysicalEdge>& edges) {
  constexpr double kCellM = 4.0;
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::set<std::pair<int, int>> touched;
    const Segment3& segment = edges[i].segment;
    const int steps = 1 + static_cast<int>(length(segment) / (0.25 * kCellM));
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector3d x = point_at(segment, static_cast<double>(k) / steps);
      for (const double dx : {-kTouchM, kTouchM}) {  // an edge on a border is in both cells
        for (const double dy : {-kTouchM, kTouchM}) {
          touched.insert({static_cast<int>(std::floor((x.x() + dx) / kCellM)),
                          static_cast<int>(std::floor((x.y() + dy) / kCellM))});
        }
      }
    }
    for (const auto& cell : touched) cells[cell].push_back(i);
  }
  return cells;
}

/// One edge over the full length of its members; its kind is that of the member with the lowest
/// rank.
PhysicalEdge merged(const std::vector<const PhysicalEdge*>& members) {
  const PhysicalEdge& longest = **std::max_element(
      members.begin(), members.end(), [](const PhysicalEdge* a, const PhysicalEdge* b) {
        return length(a->segment) < length(b->segment);
      });
  const PhysicalEdge& best = **std::min_element(
      members.begin(), members.end(),
      [](const PhysicalEdge* a, const PhysicalEdge* b) { return a->rank < b->rank; });
  const Eigen::Vector3d direction = (longest.segment.end - longest.segment.start).normalized();
  double low = 0.0;
  double high = 0.0;
  for (const PhysicalEdge* member : members) {
    for (const Eigen::Vector3d& x : {member->segment.start, member->segment.end}) {
      const double along = direction.dot(x - longest.segment.start);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  return {{longest.segment.start + low * direction, longest.segment.start + high * direction},
          best.kind,
          best.rank};
}

}  // namespace

std::vector<PhysicalEdge> physical_edges(const SyntheticScene& scene) {
  std::vector<PhysicalEdge> pieces;
  for (const SceneLine& line : scene.lines) pieces.push_back({line.segment, name(line.kind), 0});
  for (const SceneLine& joint : scene.joints) pieces.push_back({joint.segment, "joint", 1});
  add_mesh_edges(scene, pieces);

  Groups groups(pieces.size());
  for (const auto& [cell, members] : cells_of(pieces)) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t k = i + 1; k < members.size(); ++k) {
        if (continue_each_other(pieces[members[i]].segment, pieces[members[k]].segment)) {
          groups.join(members[i], members[k]);
        }
      }
    }
  }
  std::map<std::size_t, std::vector<const PhysicalEdge*>> sets;
  for (std::size_t i = 0; i < pieces.size(); ++i) sets[groups.root(i)].push_back(&pieces[i]);
  std::vector<PhysicalEdge> edges;
  edges.reserve(sets.size());
  for (const auto& [root, members] : sets) edges.push_back(merged(members));
  return edges;
}

}  // namespace ridgeline::simulate
