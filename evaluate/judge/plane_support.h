// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_search.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A plane near a line that could judge it, with the evidence for it. The line's height is no part
/// of the evidence: it may not choose its own judge.
struct CandidatePlane {
  PlaneFit fit;                    ///< over all connected inliers of the zone
  std::vector<ZonePoint> inliers;  ///< of the zone
  std::vector<ZonePoint> beside;   ///< the inliers inside the corridor
  double coverage = 0.0;           ///< share of the line's length accompanied by `beside`
};

/// Mean distance between neighbouring points, from n points on an area.
double point_spacing_m(std::size_t n, double area_m2);

/// Share of [0, length] within `reach_m` of one of the points' s.
double coverage_along(std::span<const ZonePoint> points, double length_m, double reach_m);

/// Largest distance in plan of a point of the footprint from the convex hull of the points; 0
/// inside.
double extrapolation_beyond(std::span<const ZonePoint> points, const Footprint& footprint);

/// Fits the plane again without the points beyond three robust standard deviations, until none is
/// left: points of neighbouring facets lie within the inlier distance near the common edge and
/// would tilt the plane by some millimetres.
void trim(CandidatePlane& plane, double inlier_distance_m);

/// The plain positions of the points.
std::vector<Eigen::Vector3d> positions(std::span<const ZonePoint> points);

/// Fills in `beside` and `coverage` from the inliers. A point stands for `reach_m` of the line
/// to either side, about the distance between points.
void describe_support(CandidatePlane& plane,
                      const Footprint& footprint,
                      double reach_m,
                      const JudgeOptions& options);

/// Why planes judge no line: one is known less well at its middle, by PlaneFit::sigma_at(), than
/// from three laser points there, as a few points off the line may happen to lie in a plane.
/// Nothing if all are known.
std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   std::span<const std::size_t> chosen,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options);

}  // namespace ridgeline::evaluate
