// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

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
  /// Of a line that ends the surface or lies on it: of the plane, and 0.3 px of gutters and steps that the matching
  /// fattens.
  [[nodiscard]] double sigma_on_line_px(double t_px) const;
  /// Whether it holds half of the strip. Of 53 planes that hold less than 0.4 beside true roof edges 15 were off by over
  /// a metre, of 2314 from 0.6 on 7: training villages, and scenes of another renderer.
  [[nodiscard]] bool is_trusted() const { return share >= 0.5; }
};

/// The plane that most pixels of the strip beside a segment lie on, by RANSAC; nothing if less than half of the strip
/// is known.
/// @param rectified  segment in the rectified left view
/// @param side       1: towards n = (-u_y, u_x), -1: away from it
std::optional<SidePlane> side_plane(const Surface& surface, const Segment2& rectified, int side);

/// A piece of a line with the planes on both sides.
struct SidesOfPiece {
  std::array<double, 2> parameters{};  ///< of its ends along the line
  double length_px = 0.0;
  std::array<std::optional<SidePlane>, 2> planes;

  [[nodiscard]] double middle() const { return 0.5 * (parameters[0] + parameters[1]); }
  /// The plane of the nearer surface, which an edge bounds; none if none is known.
  [[nodiscard]] const SidePlane* nearer() const;
};

/// @param parameters  of the piece of the segment
SidesOfPiece sides_of(const Surface& surface,
                      const Segment2& rectified,
                      const std::array<double, 2>& parameters);

/// The planes beside every 30 px of a segment, at most ten pieces.
std::vector<SidesOfPiece> sides_along(const Surface& surface, const Segment2& rectified);

}  // namespace ridgeline::reconstruct
