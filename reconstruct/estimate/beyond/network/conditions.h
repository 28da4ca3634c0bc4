// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/geometry/uncertain/pluecker.h"

#include <Eigen/Core>

#include <array>

namespace ridgeline::reconstruct {

/// A function of one line with its derivatives, all in the conditioned frames.
struct OfLine {
  double value = 0.0;
  Vector6d by_line = Vector6d::Zero();
};

/// A function of two lines with its derivatives, all in the conditioned frames.
struct OfLinePair {
  double value = 0.0;
  Vector6d by_first = Vector6d::Zero(), by_second = Vector6d::Zero();
};

/// The conditions that an image imposes on a line: the distances of the line's image from two
/// points of the observed line, divided by their standard deviation sqrt(2) sigma_q. The points lie
/// on either side of the centroid so that their distances are uncorrelated. The sign of both
/// distances changes with that of the line.
class ImageCondition {
 public:
  /// @param observed  has a covariance of rank 2: shift at the centroid and direction
  ImageCondition(const ProjectionMatrix& image_from_object, const UncertainLine2& observed);

  [[nodiscard]] std::array<OfLine, 2> at(const Vector6d& line) const;

 private:
  Eigen::Matrix<double, 3, 6> image_from_line_;
  std::array<Eigen::Vector3d, 2> points_;
  double sigma_;
};

/// Signed distance between two lines; its sign depends on the signs of the lines. Not finite for
/// parallel lines.
OfLinePair meeting(const Vector6d& first, const Vector6d& second);

/// The sine of the slope of a line, which is its rise over its length; Z is up.
OfLine rise(const Vector6d& line);

/// Height of the point where the line passes through a plane.
OfLine height_in_plane(const Vector6d& line, const Eigen::Vector4d& plane);

/// The plane whose image is the line through x normal to the segment.
Eigen::Vector4d end_plane(const ConditionedView& view,
                          const Segment2& segment,
                          const Eigen::Vector2d& x);

/// The condition that the ends of two segments show the same point. Its value is a distance in the
/// right image along the right segment: from the right end to the point where the line passes
/// through the end plane of the left segment.
OfLine end_parallax(const Vector6d& line,
                    const Eigen::Vector4d& left_end_plane,
                    const ConditionedView& right_view,
                    const Segment2& right_segment,
                    const Eigen::Vector2d& right_end);

}  // namespace ridgeline::reconstruct
