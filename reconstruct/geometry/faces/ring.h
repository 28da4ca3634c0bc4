// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ridgeline {

/// The corners of a polygon in space; the last one is not the first one again.
using Ring = std::vector<Eigen::Vector3d>;

/// The normal of a ring by Newell's method, as long as its area; it needs no choice of three
/// vertices. Seen from its tip, the ring runs counter-clockwise. Zero of fewer than three vertices.
/// Relative to the first vertex, as world coordinates would cost digits.
inline Eigen::Vector3d area_vector(const Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  return 0.5 * sum;
}

/// The mean of the vertices, of which there is one at least.
inline Eigen::Vector3d mean_of(const Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : ring) sum += x - ring[0];
  return ring[0] + sum / static_cast<double>(ring.size());
}

}  // namespace ridgeline
