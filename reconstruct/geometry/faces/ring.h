// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ridgeline {

/// The corners of a polygon in space; the first corner is not repeated at the end.
using Ring = std::vector<Eigen::Vector3d>;

/// The normal of a ring by Newell's method, which does not depend on a choice of three vertices;
/// its length is the area of the ring. Seen from its tip, the ring runs counter-clockwise. Zero for
/// fewer than three vertices. Computed relative to the first vertex, because world coordinates
/// would cost digits.
inline Eigen::Vector3d area_vector(const Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  return 0.5 * sum;
}

/// The mean of the vertices; there must be at least one.
inline Eigen::Vector3d mean_of(const Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : ring) sum += x - ring[0];
  return ring[0] + sum / static_cast<double>(ring.size());
}

}  // namespace ridgeline
