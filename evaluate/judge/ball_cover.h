// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

namespace ridgeline::evaluate {

struct Ball {
  Eigen::Vector3d centre;
  double radius_m;
};

/// Balls that cover all points of an extent within a radius of a segment in plan, whatever their
/// height. The corridor is divided into boxes along the segment and over the heights, and each box
/// lies in a ball. One ball over the whole corridor would take in hundreds of metres of a hilly
/// cloud.
class BallCover {
 public:
  /// There are no balls if the corridor lies outside the extent. `segment` must be finite.
  BallCover(const Segment2& segment, double radius_m, const Eigen::AlignedBox3d& extent);

  [[nodiscard]] int size() const { return along_.count * up_.count; }
  [[nodiscard]] Ball ball(int i) const;
  /// Index of the one ball whose box holds the point; for a point outside the boxes that of the
  /// nearest box.
  [[nodiscard]] int ball_of(const Eigen::Vector3d& x) const;

 private:
  /// A range in equal steps; it has no steps by default.
  struct CoverSteps {
    /// As few steps as possible that are not longer than `longest_m`; longer ones if these would be
    /// very many.
    static CoverSteps over(double from_m, double to_m, double longest_m);
    [[nodiscard]] double centre(int i) const { return from_m + (i + 0.5) * step_m; }
    [[nodiscard]] int at(double x_m) const;
    double from_m = 0.0, step_m = 0.0;
    int count = 0;
  };

  static CoverSteps steps_along(const Segment2& segment,
                                const Eigen::Vector2d& direction,
                                double radius_m,
                                const Eigen::AlignedBox3d& extent);

  Eigen::Vector2d start_;
  Eigen::Vector2d direction_;
  CoverSteps along_, up_;
  double ball_radius_m_;
};

}  // namespace ridgeline::evaluate
