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

/// Decides which planes judge a line. A ridge (also a hip or valley) has two planes that meet along the
/// line in plan and lie on opposite sides of their intersection. Any other line is a step: it is judged
/// by the plane whose border or interior it follows. If it follows several, the upper one judges it,
/// because an edge seen from the air belongs to the upper surface.
/// If the line has image segments, the plane whose edge they show judges a step instead. If they do not
/// tell the planes apart, it is the upper one, and the line gets the flag `plane_ambiguous`. A plane whose
/// points end farther from the line than step_offset_m, or that accompanies less of the line than the
/// others, though at least min_coverage of it, judges only if the images show the line on it and not on
/// the others. The line then gets the flag `seen_instead`, which judge_line() also gives to a line that it
/// looked for in another place.
/// If the line is the border of one surface on a side that is known (`inside`, see JudgedLine), it is a step, judged by a plane
/// with most of its points beside the line on that side. Of an edge and the foot of a wall below it, which lie at one place in plan, each
/// has its own plane so.
EdgeDecision decide_edge(std::span<const CandidatePlane> candidates,
                         const Footprint& footprint,
                         const JudgeOptions& options,
                         const std::optional<ImageEvidence>& images = std::nullopt,
                         const std::optional<Eigen::Vector2d>& inside = std::nullopt);

}  // namespace ridgeline::evaluate
