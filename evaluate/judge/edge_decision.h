// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"
#include "evaluate/line_evaluation.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Which planes judge a line, from plan geometry and the points alone: the line's height plays no
/// part, so that a line cannot choose the plane that flatters it.
struct EdgeDecision {
  Status status = Status::kNoPlane;  ///< `evaluated`, or why no plane was chosen
  std::string reason;
  Kind kind = Kind::kNone;
  std::vector<std::size_t> planes;  ///< indices of the candidates: one (step) or two (ridge)
  std::vector<std::string> flags;
};

/// How two planes meet beside a line, in plan.
struct PlaneMeeting {
  double offset_m;       ///< larger distance of the footprint's ends from the intersection line
  double direction_rad;  ///< between the footprint and the intersection line
  double coverage;       ///< share of the line along which both planes come up to the intersection
};

/// No answer if the planes are parallel in plan, or not one on each side of their intersection.
std::optional<PlaneMeeting> meeting_of(const CandidatePlane& a,
                                       const CandidatePlane& b,
                                       const Footprint& footprint,
                                       const JudgeOptions& options);

/// Fits both planes of a ridge again, each to its points on its own side of their intersection:
/// beyond it the points within the inlier distance belong to the other one.
void separate_at_intersection(CandidatePlane& a, CandidatePlane& b);

/// Ridge (also hip and valley): two planes that meet along the line in plan and lie on opposite
/// sides of their intersection. Otherwise step: the plane whose border or interior the line
/// follows; where several do, the upper one, because an edge seen from the air belongs to the upper
/// surface.
/// With the image segments of the line, the plane whose edge they show decides a step instead; where
/// they tell the planes not apart it is the upper one, flag `plane_ambiguous`. A plane
/// whose points end farther from the line than step_offset_m, or that accompanies less of it than the
/// others but min_coverage of it, judges only if the images show the line on it and not on these, flag
/// `seen_instead` (which judge_line() gives to a line that it looked for in another place, too).
EdgeDecision decide_edge(std::span<const CandidatePlane> candidates,
                         const Footprint& footprint,
                         const JudgeOptions& options,
                         const std::optional<ImageEvidence>& images = std::nullopt);

}  // namespace ridgeline::evaluate
