// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <optional>

namespace ridgeline::reconstruct {

/// The surface along one side of a line of the rectified left view, a plane in its disparities:
/// d = at_middle + along t + away s, t from the middle of the segment and s away from it, pixels.
struct SidePlane {
  Eigen::Vector3d at_middle_along_away = Eigen::Vector3d::Zero();
  Eigen::Matrix3d cov = Eigen::Matrix3d::Zero();
  double share = 0.0;  ///< of the strip's pixels that lie on it

  /// On the line, towards which the plane is extended.
  [[nodiscard]] double on_line(double t_px) const {
    return at_middle_along_away[0] + at_middle_along_away[1] * t_px;
  }
  [[nodiscard]] double variance_on_line(double t_px) const {
    const Eigen::Vector3d by(1.0, t_px, 0.0);
    return by.dot(cov * by);
  }
};

/// The plane that most pixels of the strip beside a segment lie on, by RANSAC; nothing if less than half of the strip
/// is known.
/// @param rectified  segment in the rectified left view
/// @param side       1: towards n = (-u_y, u_x), -1: away from it
std::optional<SidePlane> side_plane(const Surface& surface, const Segment2& rectified, int side);

}  // namespace ridgeline::reconstruct
