// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"
#include "evaluate/judge/plane_fit.h"

#include <Eigen/Core>

#include <span>

namespace ridgeline::evaluate {

/// Standard deviation of the plane at the foot point of `x`, along its normal: 1.96 times this
/// value is the half width of its 95 % interval. It is the larger of two estimates:
///   - PlaneFit::sigma_at(), as if the points' errors were independent;
///   - the estimate from the sums of the residuals over cells of 2 m in the footprint's axes
///     ("cluster-robust", Liang and Zeger 1986). These sums are larger than expected for
///     independent errors if neighbouring points have similar errors: scanner strips, objects on a
///     roof, points of the adjacent facet.
/// Each is multiplied by the ratio of the 97.5 % quantiles of Student's and the normal
/// distribution, with n - 3 degrees of freedom, n being the number of points or of cells. The
/// second estimate needs more than three cells. The result is infinite for three points.
double plane_sigma_m(const PlaneFit& fit,
                     std::span<const ZonePoint> points,
                     const Eigen::Vector3d& x);

}  // namespace ridgeline::evaluate
