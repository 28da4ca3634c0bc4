// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/footprint.h"

#include <cstddef>
#include <vector>

namespace ridgeline::evaluate {

/// A laser point over or beside a face.
struct FacePoint {
  ZonePoint point;      ///< s and t: x and y relative to the face's centroid
  double beyond_m;      ///< distance from the outline in plan, negative over the face
  std::size_t edge;     ///< index of the nearest edge in PlanPolygon::edges()
  bool beside = false;  ///< whether its foot point lies within that edge
};

/// The centre line of a box along its longer side, and how far the box extends on either side of
/// it.
struct Corridor {
  Segment2 axis;
  double half_width_m;
};
Corridor corridor_of(const Eigen::AlignedBox2d& box);

/// The points over a face that is not degenerate and up to `reach_m` beside it in plan, at any
/// height. They are sorted by x, then y, then z, and points at the same position are kept once, so
/// that the same points give the same result regardless of their order in the cloud.
std::vector<FacePoint> points_around(const PointSearch& search,
                                     const RoofFace& face,
                                     double reach_m);

}  // namespace ridgeline::evaluate
