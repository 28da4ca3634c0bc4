// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/edge_heights.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/faces/ring.h"
#include "reconstruct/geometry/faces/roof_edge.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kTouching_m = 0.05;  // between edges that coincide in a model

/// Where a face lies relative to one of its level edges.
enum class EdgeSide : std::uint8_t { kBelow, kAbove, kBeside };

struct LevelEdge {
  std::size_t face;
  Segment3 segment;
  EdgeSide side;
};

EdgeSide side_of(const RoofFace& face, const Segment3& edge, bool counter_clockwise) {
  if (slope_rad(face.plane) < kLevelRoof_rad) return EdgeSide::kBeside;
  const Eigen::Vector3d along = edge.end - edge.start;
  const double sign = counter_clockwise ? 1.0 : -1.0;
  const Eigen::Vector2d inwards(-sign * along.y(), sign * along.x());
  return inwards.dot(face.plane.normal().head<2>()) > 0.0 ? EdgeSide::kBelow : EdgeSide::kAbove;
}

/// The level edges of all faces' outer rings.
std::vector<LevelEdge> level_edges(std::span<const RoofFace> faces) {
  std::vector<LevelEdge> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].degenerate) continue;
    const std::vector<Eigen::Vector3d>& ring = faces[f].rings.front();
    const bool counter_clockwise = area_vector(ring).z() > 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment3 edge{ring[i], ring[(i + 1) % ring.size()]};
      if (is_level(edge) && length(plan(edge)) > 0.0)
        edges.push_back({f, edge, side_of(faces[f], edge, counter_clockwise)});
    }
  }
  return edges;
}

/// Finds the edge of another face at the midpoint of an edge.
class Partners {
 public:
  explicit Partners(const std::vector<LevelEdge>& edges)
      : edges_(edges), index_(transformed(edges, [](const LevelEdge& edge) {
          return plan_box_of(std::array{edge.segment.start, edge.segment.end});
        })) {}

  /// The first such edge, or nullptr.
  [[nodiscard]] const LevelEdge* of(const LevelEdge& edge) const {
    const Eigen::Vector3d middle = midpoint(edge.segment);
    for (const std::size_t i : index_.near(Eigen::AlignedBox2d(middle.head<2>()), kTouching_m)) {
      const LevelEdge& other = edges_[i];
      if (other.face != edge.face && distance(other.segment, middle) <= kTouching_m) return &other;
    }
    return nullptr;
  }

 private:
  const std::vector<LevelEdge>& edges_;
  BoxIndex2 index_;
};

/// How high the edge lies above the line in which two planes meet; empty for nearly parallel
/// planes.
std::optional<double> above_intersection_m(const LevelEdge& edge,
                                           const Plane3& a,
                                           const Plane3& b) {
  constexpr double kParallel = 0.1;  // sine of 6 degrees
  const Eigen::Vector3d middle = midpoint(edge.segment);
  const Eigen::Vector3d along = (edge.segment.end - edge.segment.start).normalized();
  if (a.normal().cross(b.normal()).norm() < kParallel) return std::nullopt;
  Eigen::Matrix3d rows;
  rows << a.normal().transpose(), b.normal().transpose(), along.transpose();
  const Eigen::Vector3d distances(a.signedDistance(middle), b.signedDistance(middle), 0.0);
  return rows.fullPivLu().solve(distances).z();
}

struct Mean {
  double sum = 0.0, weight = 0.0;
  void add(double value, double by) { sum += by * value, weight += by; }
  [[nodiscard]] std::optional<double> value() const {
    return weight > 0.0 ? std::optional(sum / weight) : std::nullopt;
  }
};

}  // namespace

EdgeHeights edge_heights(std::span<const RoofFace> faces,
                         std::span<const FaceEvaluation> evaluations) {
  const auto is_judged = [&](std::size_t face) {
    return evaluations[face].status == FaceStatus::kEvaluated;
  };
  const std::vector<LevelEdge> edges = level_edges(faces);
  const Partners partners(edges);
  Mean ridge, eave;
  for (const LevelEdge& edge : edges) {
    if (!is_judged(edge.face)) continue;
    const Plane3& plane = evaluations[edge.face].fit.plane;
    const Eigen::Vector3d middle = midpoint(edge.segment);
    const double above_plane_m = middle.z() - height_at(plane, middle.head<2>());
    const LevelEdge* partner = partners.of(edge);
    if (edge.side != EdgeSide::kBelow) {
      if (!partner) eave.add(above_plane_m, length(edge.segment));
      continue;
    }
    if (partner && partner->side != EdgeSide::kBelow) continue;  // the kink of a mansard
    std::optional<double> above_m;
    if (partner && is_judged(partner->face)) {
      above_m = above_intersection_m(edge, plane, evaluations[partner->face].fit.plane);
    }
    ridge.add(above_m.value_or(above_plane_m), length(edge.segment));
  }
  return {ridge.value(), eave.value()};
}

}  // namespace ridgeline::evaluate
