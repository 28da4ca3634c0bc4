// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/face_edges.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/faces/face_seams.h"
#include "reconstruct/geometry/faces/roof_edge.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ridgeline {
namespace {

constexpr double kMinFoldAngle_deg = 5.0;

/// The faces of a building with their planes.
class KindsOfEdges {
 public:
  explicit KindsOfEdges(std::span<const Face> faces)
      : faces_(faces),
        planes_(transformed(faces, [](const Face& face) { return *plane_of(face); })) {}

  [[nodiscard]] std::vector<std::size_t> with_kind(const FaceSeam& seam, FaceKind kind) const {
    std::vector<std::size_t> found = seam.faces;
    std::erase_if(found, [&](std::size_t face) { return faces_[face].kind != kind; });
    return found;
  }

  /// Empty for a seam that is not an edge.
  [[nodiscard]] std::string kind_of(const FaceSeam& seam,
                                    const std::vector<std::size_t>& roofs) const {
    if (roofs.size() == 1) return kind_of_border_of(seam, roofs[0]);
    return roofs.size() == 2 ? kind_of_fold(seam.segment, roofs[0], roofs[1]) : "";
  }

 private:
  [[nodiscard]] std::string kind_of_border_of(const FaceSeam& seam, std::size_t roof) const {
    const auto rises = [&](std::size_t wall) {
      const auto way = inward(wall, seam.segment);
      return way && way->z() > 0.0;
    };
    const bool is_foot = std::ranges::any_of(with_kind(seam, FaceKind::kWall), rises);
    return is_foot ? "step" : kind_of_border(upward(planes_[roof]), seam.segment);
  }

  /// The kind of the edge between two roof faces; empty if they are nearly coplanar.
  [[nodiscard]] std::string kind_of_fold(const Segment3& edge, std::size_t a, std::size_t b) const {
    const Eigen::Vector3d normal_a = upward(planes_[a]).normal();
    const Eigen::Vector3d normal_b = upward(planes_[b]).normal();
    if (acute_angle_rad(normal_a, normal_b) < kMinFoldAngle_deg * kRadPerDeg) return "";
    const auto inward_a = inward(a, edge), inward_b = inward(b, edge);
    const double above =
        (inward_a ? normal_b.dot(*inward_a) : 0.0) + (inward_b ? normal_a.dot(*inward_b) : 0.0);
    if (above > 0.0) return "valley";
    return is_level(edge) ? "ridge" : "hip";
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> inward(std::size_t face,
                                                      const Segment3& edge) const {
    return inward_of(faces_[face], planes_[face], edge);
  }

  std::span<const Face> faces_;
  std::vector<Plane3> planes_;
};

}  // namespace

FaceEdges edges_of_roofs(std::span<const Face> faces) {
  const KindsOfEdges kinds(faces);
  FaceEdges found;
  for (const FaceSeam& seam : seams_of(faces)) {
    std::vector<std::size_t> roofs = kinds.with_kind(seam, FaceKind::kRoof);
    if (roofs.size() > 2) ++found.n_crowded;
    std::string kind = kinds.kind_of(seam, roofs);
    if (kind.empty()) continue;
    found.edges.push_back({seam.segment, std::move(kind), std::move(roofs)});
  }
  return found;
}

}  // namespace ridgeline
