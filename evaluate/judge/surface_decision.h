// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/edge_decision.h"
#include "evaluate/judge/surface_hypotheses.h"
#include "evaluate/line_evaluation.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Log-likelihoods of a hypothesis by each kind of evidence, up to a constant that all hypotheses of a line share.
struct SurfaceEvidence {
  double plan = 0.0, images = 0.0, points = 0.0, place = 0.0;
};

/// The evidence for each hypothesis.
///
///   - plan: a linear function of PlanTerm.
///   - images, where a third sighting lies off the base of the first two: each plane carries the base sighting into every
///     other image, an object carries the line that the first two sightings triangulate to into the others; what counts
///     are the distances from the sightings over sigma_edge_px.
///   - points: those along an object that no plane explains.
///   - place, where the images do not count: the distance of the line over place_sigma_m and the plane's sigma, against
///     a wrong line that may be anywhere. Two sightings only triangulate to the line, so they are no evidence beside it.
///     It says nothing of an object.
std::vector<SurfaceEvidence> surface_evidence(std::span<const SurfaceHypothesis> hypotheses,
                                              std::span<const CandidatePlane> candidates,
                                              const Segment3& segment,
                                              const std::optional<ImageEvidence>& images,
                                              const JudgeOptions& options);

/// Which planes judge a line, and of which surface it is an edge by that. The latter is empty if decide_edge() decided.
struct SurfaceDecision : EdgeDecision {
  std::optional<Surface> surface{}, other{};
  std::optional<double> probability{};  ///< of `surface`
  std::optional<DecidedBy> decided_by{};
};

/// The most probable hypothesis. Those that lie at one height along the line are one surface, whose probabilities add up,
/// as any of them gives the same distance. A surface below min_probability makes the line `ambiguous`.
SurfaceDecision decide_surface(std::span<const ZonePoint> zone,
                               std::span<const CandidatePlane> candidates,
                               const Footprint& footprint,
                               const JudgedLine& line,
                               const JudgeOptions& options);

}  // namespace ridgeline::evaluate
