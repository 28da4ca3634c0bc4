// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace ridgeline::reconstruct {

/// The curve of a normal distribution, scaled to 1 at z = 0.
inline double bell(double z) { return std::exp(-0.5 * z * z); }

/// A line in the projection plane of the base segment, conditioned frame.
struct DepthLine {
  Eigen::Vector3d through = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector
};

/// Points closer together along the segment than this share of it do not determine a direction.
inline constexpr double kMinBase = 0.2;

/// A point that a line may pass through, in the conditioned object frame.
struct DepthEvidence {
  Eigen::Vector3d x;
  Eigen::Matrix3d cov;
  double parameter = 0.0;  ///< position along the base segment, 0 at its start and 1 at its end
  double prior = 0.5;      ///< probability that it is on the line, without other evidence
  /// Weight of a point where another line seems to meet this one; 0 for the ends of the line's own
  /// segments.
  double meeting = 0.0;
  bool may_cut = false;  ///< whether the track may be cut here into several lines
};

}  // namespace ridgeline::reconstruct
