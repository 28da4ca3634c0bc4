// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_search.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A plane near a line that could judge it, with the evidence for it. The line's height is not part
/// of the evidence: it must not influence which plane judges the line.
struct CandidatePlane {
  PlaneFit fit;                    ///< over all connected inliers of the zone
  std::vector<ZonePoint> inliers;  ///< of the zone
  std::vector<ZonePoint> beside;   ///< the inliers inside the corridor
  double coverage = 0.0;  ///< share of the line's length that has points of `beside` next to it
};

/// Mean distance between neighbouring points, from n points on an area.
double point_spacing_m(std::size_t n, double area_m2);

/// Share of [0, length] within `reach_m` of the s of at least one of the points.
double coverage_along(std::span<const ZonePoint> points, double length_m, double reach_m);

/// Largest distance in plan of a point of the footprint from the convex hull of the points; 0
/// inside it.
double extrapolation_beyond(std::span<const ZonePoint> points, const Footprint& footprint);

/// Refits the plane without the points beyond three robust standard deviations, until none is left:
/// near a common edge, points of neighbouring facets lie within the inlier distance and would tilt
/// the plane by some millimetres.
void trim(CandidatePlane& plane, double inlier_distance_m);

/// The positions of the points only.
std::vector<Eigen::Vector3d> positions(std::span<const ZonePoint> points);

/// Fills in `beside` and `coverage` from the inliers. A point covers `reach_m` of the line on
/// either side, about the distance between points.
void describe_support(CandidatePlane& plane,
                      const Footprint& footprint,
                      double reach_m,
                      const JudgeOptions& options);

/// Why the planes cannot judge a line: the position of one of them at the middle of the line is
/// less certain, by PlaneFit::sigma_at(), than that from three laser points there, because a few
/// points away from the line may happen to lie in a plane. Empty if all are certain enough.
std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   std::span<const std::size_t> chosen,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options);

}  // namespace ridgeline::evaluate
