// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ridgeline::evaluate {

/// A polygon with holes in plan. Its rings may have either orientation.
class PlanPolygon {
 public:
  /// The position on the outline that is nearest to a point.
  struct Nearest {
    std::size_t edge = 0;     ///< index in edges(); the first if there are several
    double distance_m = 0.0;  ///< not negative
    bool beside = false;  ///< whether the foot point lies within the edge, not at one of its ends
  };

  PlanPolygon() = default;
  /// The first ring is the outer one. Edges of zero length are left out.
  explicit PlanPolygon(const std::vector<std::vector<Eigen::Vector3d>>& rings);

  /// By the even-odd rule; a point on the outline may be either inside or outside.
  [[nodiscard]] bool contains(const Eigen::Vector2d& x) const;
  /// Requires at least one edge.
  [[nodiscard]] Nearest nearest(const Eigen::Vector2d& x) const;
  /// Distance to the polygon; 0 inside it.
  [[nodiscard]] double distance_m(const Eigen::Vector2d& x) const;

  [[nodiscard]] const std::vector<Segment2>& edges() const { return edges_; }
  [[nodiscard]] const Eigen::AlignedBox2d& box() const { return box_; }
  [[nodiscard]] double area_m2() const { return area_m2_; }
  /// The centroid; the middle of the box if the area is 0.
  [[nodiscard]] const Eigen::Vector2d& centroid() const { return centroid_; }

 private:
  void set_area(const std::vector<std::vector<Eigen::Vector3d>>& rings);

  std::vector<Segment2> edges_;
  Eigen::AlignedBox2d box_;
  double area_m2_ = 0.0;
  Eigen::Vector2d centroid_ = Eigen::Vector2d::Zero();
};

}  // namespace ridgeline::evaluate
