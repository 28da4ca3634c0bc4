// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"

#include <optional>

namespace ridgeline::evaluate {

/// Angle between the planes, in [0, pi/2].
double angle_between_rad(const PlaneFit& a, const PlaneFit& b);

/// How two planes meet beside a line, in plan.
struct PlaneMeeting {
  double offset_m;  ///< larger distance of the two ends of the footprint from the intersection line
  double direction_rad;  ///< between the footprint and the intersection line
  double coverage;       ///< share of the line along which both planes reach the intersection
};

/// How two planes meet beside a line. Empty if they are parallel in plan, or if they do not lie one
/// on each side of their intersection.
std::optional<PlaneMeeting> meeting_of(const CandidatePlane& a,
                                       const CandidatePlane& b,
                                       const Footprint& footprint,
                                       const JudgeOptions& options);

/// Fits both planes of a ridge again, each to its points on its own side of their intersection.
/// Points beyond the intersection that lie within the inlier distance belong to the other plane.
void separate_at_intersection(CandidatePlane& a, CandidatePlane& b);

}  // namespace ridgeline::evaluate
