// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// An image point and the camera that saw it, in the conditioned frames.
struct ViewedPoint {
  ProjectionMatrix image_from_object;
  UncertainPoint2 point;  ///< spherically normalised
};

struct EstimatedPoint {
  UncertainPoint3 point;  ///< unit length; covariance of rank 3 with the point as null vector
  /// Sum of the squared normalised residuals, chi-square with 2 n - 3 degrees of freedom; for two
  /// images it tests the epipolar geometry.
  double omega = 0.0;
  int passes = 0;
};

/// The 3D point estimated from its images by an iterated Gauss-Helmert adjustment with one
/// constraint (Ok et al. 2011, Eqs. 3 and 4): observations x_j, conditions S_r(x_j) P_j X = 0,
/// constraint |X| = 1. It starts from the null vector of the stacked S(x_j) P_j. At least two
/// observations are needed; they are assumed to be uncorrelated. Empty if it does not converge in
/// ten passes or the point is not determined. Throws std::invalid_argument for fewer than two
/// observations.
std::optional<EstimatedPoint> estimate_point(std::span<const ViewedPoint> observations);

}  // namespace ridgeline::reconstruct
