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

/// What can speak in plan for or against a line being an edge of a surface. Terms of another kind of surface are 0.
enum PlanTerm : std::size_t {
  // of a step
  kIsUpper,          ///< 1 if no higher plane accompanies the line
  kIsLower,          ///< 1 if one does
  kIsGround,         ///< 1 for a lower plane that is the lowest and a storey below the highest
  kStepMissing,      ///< share of the line that the plane does not accompany
  kGap,              ///< by how much the plane ends before the line, m
  kUpperReach,       ///< by how much an upper plane goes on beyond the line, m
  kLowerReach,       ///< the same of a lower one
  kCovered,          ///< share of the line over which a higher plane lies
  kFewPoints,        ///< 1 / sqrt of the plane's points
  kIsLowObject,      ///< 1 for a car, a box
  kIsLedge,          ///< 1 for the narrow top of a wall
  // of two planes that meet
  kIsMeeting,        ///< 1
  kMeetingOffset,    ///< largest distance in plan of the line from where they meet, m
  kMeetingDirection, ///< angle in plan between the two, rad
  kMeetingMissing,   ///< share of the line along which not both come up to the meeting
  kMeetingFlat,      ///< how little they differ in direction: 10 degrees over their angle
  // of an object that the cloud has no plane for
  kIsObject,         ///< 1
  kOneSideEmpty,     ///< 1 if the cloud has points on one side of the line only
  kNumPlanTerms
};

/// What the points that no plane explains say.
enum PointTerm : std::size_t {
  kStandBeside,  ///< share of the points within 0.8 m that stand on the surface, of a plane
  kStandIn,      ///< share of the points within 0.3 m that do, of a plane
  kAccompany,    ///< share of the line that has such points within 0.3 m in space, of an object
  kNumPointTerms
};

/// A surface that a line may be an edge of.
struct SurfaceHypothesis {
  Surface surface = Surface::kObject;
  std::vector<std::size_t> planes;                ///< candidates: one, two that meet, none of an object
  Eigen::Vector2d heights_m{HUGE_VAL, HUGE_VAL};  ///< at the ends of the footprint; mean of two planes
  std::array<double, kNumPlanTerms> plan{};
  std::array<double, kNumPointTerms> points{};
};

/// The surfaces that a line may be an edge of: each candidate that accompanies enough of it, each pair that meets
/// along it, and, first, an object without a plane. Of the border of a surface on a known side (`inside`, see
/// JudgedLine) only planes that lie on that side count, one by one.
std::vector<SurfaceHypothesis> surface_hypotheses(std::span<const ZonePoint> zone,
                                                  std::span<const CandidatePlane> candidates,
                                                  const Footprint& footprint,
                                                  const Segment3& segment,
                                                  const std::optional<Eigen::Vector2d>& inside,
                                                  const JudgeOptions& options);

}  // namespace ridgeline::evaluate
