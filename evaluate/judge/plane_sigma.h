// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"
#include "evaluate/judge/plane_fit.h"

#include <Eigen/Core>

#include <span>

namespace ridgeline::evaluate {

/// How well the plane is known at the foot of `x`, along its normal: 1.96 times this is the half
/// width of its 95 % interval. It is the larger of two estimates:
///   - PlaneFit::sigma_at(), as if the points' errors were independent;
///   - the estimate from the residuals' sums over cells of 2 m in the footprint's axes
///     ("cluster-robust", Liang and Zeger 1986). These sums are too large for independent errors
///     where neighbours err together: strips of the scanner, things on a roof, points of the next
///     facet.
/// Each is multiplied by the ratio of the 97.5 % quantiles of Student's and the normal
/// distribution, with the degrees of freedom of its points (n - 3) or cells (n - 3). The second
/// needs more than three cells. The result is infinite for three points.
double plane_sigma_m(const PlaneFit& fit,
                     std::span<const ZonePoint> points,
                     const Eigen::Vector3d& x);

}  // namespace ridgeline::evaluate
