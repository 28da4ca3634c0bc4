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

/// Knots for the place of a plane's border, see PlanTerm.
inline constexpr std::array kBorders_m{-0.8, -0.3, 0.0, 0.3, 0.6, 1.2};

/// What can speak in plan for or against a line being an edge of a surface. Terms of another kind
/// of surface are 0.
enum PlanTerm : std::size_t {
  // of a plane that no higher one accompanies: its border lies before the line (-), at it, or
  // beyond it (+), as
  // shares of the nearest two of kBorders_m
  kUpperBorder,
  // the same of a plane with a higher one beside it
  kLowerBorder = kUpperBorder + kBorders_m.size(),
  kIsGround =
      kLowerBorder + kBorders_m.size(),  ///< 1 for a lower plane that is the lowest, a storey below
  kLowStep,         ///< how little higher the next higher plane is: from 1 at 0 m to 0 at 2 m
  kUnderLowBorder,  ///< kLowStep times how near that plane's border is: from 1 at the line to 0 at
                    ///< 0.3 m
  kCovered,         ///< share of the line over which a higher plane lies
  kMissing,         ///< share of the line that the plane does not accompany
  kFewPoints,       ///< 1 / sqrt of the plane's points
  kLowerFewPoints,  ///< the same of a plane with a higher one beside it
  kIsLedge,         ///< 1 for the narrow top of a wall
  // points that no plane explains, and that stand on the surface: shares of the points beside the
  // line
  kStandBeside,  ///< within 0.8 m, on an upper surface or on two that meet
  kStandIn,      ///< the same within 0.3 m
  kStandLower,   ///< within 0.8 m, on a surface with a higher one beside it
  // of two planes that meet
  kIsMeeting,         ///< 1
  kMeetingOffset,     ///< largest distance in plan of the line from where they meet, m
  kMeetingDirection,  ///< angle in plan between the two, rad
  kMeetingMissing,    ///< share of the line along which not both come up to the meeting
  kMeetingFlat,       ///< how little they differ in direction: 10 degrees over their angle
  // of an object that the cloud has no plane for
  kOneSideEmpty,  ///< 1 if the cloud has points on one side of the line only
  kShort,  ///< 1 m over the length of the line: the smaller a surface, the sooner its plane is
           ///< missed
  kNumPlanTerms
};

/// A surface that a line may be an edge of.
struct SurfaceHypothesis {
  JudgingSurface surface = JudgingSurface::kObject;
  /// Candidates: one, two that meet, of an object none.
  std::vector<std::size_t> planes;
  Eigen::Vector2d heights_m{HUGE_VAL,
                            HUGE_VAL};  ///< at the ends of the footprint; mean of two planes
  std::array<double, kNumPlanTerms> plan{};
  // of an object
  double accompanied = 0.0;  ///< share of the line with unexplained points within 0.3 m in space
  bool has_points = false;   ///< within 1 m in space, on no plane of the other hypotheses
};

/// The surfaces that a line may be an edge of: each candidate that accompanies enough of it, each
/// pair that meets along it, and, first, an object without a plane. Of the border of a surface on a
/// known side (`inside`, see JudgedLine) only planes that lie on that side count, one by one.
std::vector<SurfaceHypothesis> surface_hypotheses(std::span<const ZonePoint> zone,
                                                  std::span<const CandidatePlane> candidates,
                                                  const Footprint& footprint,
                                                  const Segment3& segment,
                                                  const std::optional<Eigen::Vector2d>& inside,
                                                  const JudgeOptions& options);

}  // namespace ridgeline::evaluate
