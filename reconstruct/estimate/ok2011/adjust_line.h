// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/uncertain/pluecker.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

struct AdjustedLine {
  UncertainLine3 line;  ///< unit vector on the Pluecker quadric; covariance of rank 4
  /// Sum of the squared normalised misclosures. Nominal redundancy 2 (planes + points) - 4; smaller
  /// where the points were derived from the lines of the same planes (Ok et al. 2011).
  double omega = 0.0;
  int passes = 0;
  bool converged = false;
  /// False if the entities leave a direction free: the line is one of many, and its covariance does
  /// not include that direction.
  bool full_rank = false;
};

/// The line in the planes and through the points, from an iterated Gauss-Markov adjustment with the
/// Pluecker and the length constraint (Ok et al. 2011, section 3.2): conditions Pi'(A) M = 0 and
/// PiBar'(X) M = 0, two independent rows of each, weighted by their covariance at the current M;
/// entities are assumed to be uncorrelated. All in one conditioned frame, spherically normalised.
///
/// The constraints are eliminated: increments live in line_tangent_basis() and M returns to the
/// quadric after each. This gives the estimate and covariance of the bordered 8x8 system, and a
/// regular 4x4 matrix whose rank can be judged. No step may increase omega.
///
/// Coincident planes fix two of the four freedoms, each point one more. The iteration starts from
/// the null vector of the stacked conditions and takes at most 20 passes. Empty for fewer than two
/// entities or a result that is not finite. With `sigma_slope`, the line is also horizontal to
/// within this sigma: condition L_h,z / |L_h| = 0, which fixes one more freedom; Z is up.
std::optional<AdjustedLine> adjust_line(std::span<const UncertainPlane3> planes,
                                        std::span<const UncertainPoint3> points,
                                        std::optional<double> sigma_slope = std::nullopt);

}  // namespace ridgeline::reconstruct
