// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

namespace ridgeline::evaluate {

struct Ball {
  Eigen::Vector3d centre;
  double radius_m;
};

/// Balls that together cover all points of an extent that lie within a radius of a segment in plan,
/// at any height. The corridor is divided into boxes along the segment and over the heights, and
/// each box lies in a ball. A single ball around the whole corridor would include hundreds of
/// metres of a hilly cloud.
class BallCover {
 public:
  /// There are no balls if the corridor lies outside the extent. `segment` must be finite.
  BallCover(const Segment2& segment, double radius_m, const Eigen::AlignedBox3d& extent);

  [[nodiscard]] int size() const { return along_.count * up_.count; }
  [[nodiscard]] Ball ball(int i) const;
  /// Index of the ball whose box contains the point, or of the nearest box if the point lies
  /// outside all boxes.
  [[nodiscard]] int ball_of(const Eigen::Vector3d& x) const;

 private:
  /// A range divided into equal steps; empty by default.
  struct CoverSteps {
    /// The smallest number of steps not longer than `longest_m`; the steps are longer if there
    /// would be very many of them.
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
