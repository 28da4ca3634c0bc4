// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"
#include "evaluate/line_evaluation.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Knots for the position of a plane's border; see PlanTerm.
inline constexpr std::array kBorders_m{-0.8, -0.3, 0.0, 0.3, 0.6, 1.2};

/// The evidence in plan for or against a line being an edge of a surface. Terms that belong to
/// another kind of surface are 0.
enum PlanTerm : std::size_t {
  // of a plane without a higher one beside it: whether its border lies before the line (-), at it,
  // or beyond it (+), as shares of the nearest two of kBorders_m
  kUpperBorder,
  // the same for a plane with a higher one beside it
  kLowerBorder = kUpperBorder + kBorders_m.size(),
  kIsGround =
      kLowerBorder + kBorders_m.size(),  ///< 1 for a lower plane that is the lowest, a storey below
  kLowStep,         ///< how close in height the next higher plane is: from 1 at 0 m to 0 at 2 m
  kUnderLowBorder,  ///< kLowStep times how close that plane's border is: from 1 at the line to 0 at
                    ///< 0.3 m
  kCovered,         ///< share of the line over which a higher plane extends
  kMissing,         ///< share of the line along which the plane has no points
  kFewPoints,       ///< 1 / sqrt of the plane's number of points
  kLowerFewPoints,  ///< the same for a plane with a higher one beside it
  kIsLedge,         ///< 1 for the narrow top of a wall
  // points that no plane explains and that stand on the surface: shares of the points beside the
  // line
  kStandBeside,  ///< within 0.8 m, on an upper surface or on two that meet
  kStandIn,      ///< the same within 0.3 m
  kStandLower,   ///< within 0.8 m, on a surface with a higher one beside it
  // of two planes that meet
  kIsMeeting,         ///< 1
  kMeetingOffset,     ///< largest distance in plan of the line from their intersection, m
  kMeetingDirection,  ///< angle in plan between the line and the intersection, rad
  kMeetingMissing,  ///< share of the line along which the planes do not both reach the intersection
  kMeetingFlat,     ///< how similar their directions are: 10 degrees over their angle
  // of an object for which the cloud has no plane
  kOneSideEmpty,  ///< 1 if the cloud has points on only one side of the line
  kShort,  ///< 1 m over the length of the line: the smaller a surface, the more easily its plane is
           ///< missed
  kNumPlanTerms
};

/// A surface of which a line may be an edge.
struct SurfaceHypothesis {
  JudgingSurface surface = JudgingSurface::kObject;
  /// Indices of the candidates: one, two that meet, or none for an object.
  std::vector<std::size_t> planes;
  Eigen::Vector2d heights_m{HUGE_VAL,
                            HUGE_VAL};  ///< at the ends of the footprint; mean for two planes
  std::array<double, kNumPlanTerms> plan{};
  // of an object
  double accompanied = 0.0;  ///< share of the line with unexplained points within 0.3 m in space
  bool has_points = false;   ///< within 1 m in space, on none of the planes of the other hypotheses
};

/// The surfaces of which a line may be an edge: first, an object without a plane, then each pair of
/// candidates that meet along the line, and each candidate that runs along enough of it. If the
/// line is the border of a surface on a known side (`inside`, see JudgedLine), only single planes
/// that lie on that side are considered.
std::vector<SurfaceHypothesis> surface_hypotheses(std::span<const ZonePoint> zone,
                                                  std::span<const CandidatePlane> candidates,
                                                  const Footprint& footprint,
                                                  const Segment3& segment,
                                                  const std::optional<Eigen::Vector2d>& inside,
                                                  const JudgeOptions& options);

}  // namespace ridgeline::evaluate
