// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <array>
#include <optional>

namespace ridgeline::evaluate {

/// Two planes that meet at a smaller angle than this determine the horizontal part of a
/// displacement too poorly: its sigma is about that of the planes divided by the sine of half the
/// angle.
inline constexpr double kMinRidgeAngle_deg = 20.0;

/// The horizontal unit vector across a line, towards larger x, or towards larger y for a line along
/// x. Zero for a vertical line, which has no such direction.
Eigen::Vector3d across_in_plan(const Segment3& segment);

/// How far a ridge or hip lies from the intersection of its planes, e = a h + b z: with z up and h
/// the horizontal unit vector across the line, the signed distances d of the line's midpoint from
/// the planes give (a, b)^T = N^-1 d with the rows (n_i . h, n_i . z) of N, and the covariance N^-1
/// diag(sigma_i^2) N^-T of the planes. The accuracy of the line's own ends plays no part. h points
/// towards larger x (larger y for a line along x), regardless of the end at which the line starts.
/// A displacement along the line cannot be observed: on a hip, b is the height difference at the
/// same position in plan. Empty if the planes meet at less than kMinRidgeAngle_deg, or the line is
/// vertical.
std::optional<RidgeDisplacement> ridge_displacement(const Segment3& segment,
                                                    const std::array<Plane3, 2>& planes,
                                                    const std::array<double, 2>& sigmas_m);

}  // namespace ridgeline::evaluate
