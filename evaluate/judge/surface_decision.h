// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"
#include "evaluate/line_evaluation.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Log-likelihoods of a hypothesis by each kind of evidence, up to a constant that all hypotheses
/// of a line share.
struct SurfaceEvidence {
  double plan = 0.0, images = 0.0, points = 0.0, place = 0.0;
  double wrong = 0.0;  ///< probability by its place that an edge of this surface does not lie on it
};

/// The evidence for each hypothesis.
///
///   - plan: a linear function of PlanTerm.
///   - images, where a third observation lies off the base of the first two: each plane carries the
///     base observation into every other image, an object carries the line that the first two
///     observations triangulate to into the others; what counts are the distances from the
///     observations over sigma_edge_px.
///   - points: those along an object that no plane explains.
///   - place, where the images do not count: the distance of the line over place_sigma_m and the
///     plane's sigma, against a wrong line that may be anywhere. Two observations only triangulate
///     to the line, so they are no evidence beside it. It says nothing of an object.
std::vector<SurfaceEvidence> surface_evidence(std::span<const SurfaceHypothesis> hypotheses,
                                              std::span<const CandidatePlane> candidates,
                                              const Segment3& segment,
                                              const std::optional<ImageEvidence>& images,
                                              const JudgeOptions& options);

/// Of which surface a line is an edge, and which planes judge it by that.
struct SurfaceDecision {
  Status status = Status::kNoPlane;  ///< `evaluated`, or why no plane was chosen
  std::string reason;
  Kind kind = Kind::kNone;
  std::vector<std::size_t> planes;  ///< indices of the candidates: one (step) or two (ridge)
  std::vector<std::string> flags;
  std::optional<JudgingSurface> surface, other;  ///< empty without candidates
  std::optional<double> probability;             ///< of `surface`
  std::optional<DecidedBy> decided_by;           ///< of an evaluated line
  bool is_far = false;  ///< the line lies on none of the surfaces that it may be an edge of
};

/// The most probable hypothesis. Those that lie at one height along the line are one surface, whose
/// probabilities add up, as any of them gives the same distance. A surface below min_probability
/// makes the line `ambiguous`, unless it lies on none of them with this probability: it is wrong
/// whichever is its own, and the likeliest one judges it.
SurfaceDecision decide_surface(std::span<const ZonePoint> zone,
                               std::span<const CandidatePlane> candidates,
                               const Footprint& footprint,
                               const JudgedLine& line,
                               const JudgeOptions& options);

}  // namespace ridgeline::evaluate
