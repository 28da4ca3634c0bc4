// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"
#include "evaluate/line_evaluation.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Log-likelihoods of a hypothesis for each kind of evidence, up to a constant common to all
/// hypotheses of a line.
struct SurfaceEvidence {
  double plan = 0.0, images = 0.0, points = 0.0, place = 0.0;
  double wrong = 0.0;  ///< probability, given the line's place, that an edge of this surface does
                       ///< not lie on it
};

/// The evidence for each hypothesis.
///
///   - plan: a linear function of PlanTerm.
///   - images, if a third observation lies off the base of the first two: each plane transfers the
///     base observation into every other image; for an object, the line triangulated from the first
///     two observations is projected into the others. The evidence is the distances from the
///     observations, divided by sigma_edge_px.
///   - points: those along an object that no plane explains.
///   - place, if the images provide no evidence: the distance of the line over place_sigma_m and
///     the plane's sigma, compared with a wrong line that may be anywhere. Two observations merely
///     triangulate to the line, so they add no evidence to it. For an object, only whether a plane
///     or points are nearby counts.
std::vector<SurfaceEvidence> surface_evidence(std::span<const SurfaceHypothesis> hypotheses,
                                              std::span<const CandidatePlane> candidates,
                                              const Segment3& segment,
                                              const std::optional<ImageEvidence>& images,
                                              const JudgeOptions& options);

/// The surface of which a line is an edge, and the planes that judge it accordingly.
struct SurfaceDecision {
  Status status = Status::kNoPlane;  ///< `evaluated`, or why no plane was chosen
  std::string reason;
  Kind kind = Kind::kNone;
  std::vector<std::size_t> planes;  ///< indices of the candidates: one (step) or two (ridge)
  std::vector<std::string> flags;
  std::optional<JudgingSurface> surface, other;  ///< empty if there are no candidates
  std::optional<double> probability;             ///< of `surface`
  std::optional<DecidedBy> decided_by;           ///< of an evaluated line
  bool is_far = false;  ///< the line lies on none of the surfaces of which it may be an edge
};

/// The most probable hypothesis. Hypotheses at the same height along the line form one surface,
/// whose probabilities add up, because each of them gives the same distance. A surface with a
/// probability below min_probability makes the line `ambiguous`, unless with this probability the
/// line lies on none of the surfaces: it is then wrong whichever of them is its own, and is judged
/// by the most probable one.
SurfaceDecision decide_surface(std::span<const ZonePoint> zone,
                               std::span<const CandidatePlane> candidates,
                               const Footprint& footprint,
                               const JudgedLine& line,
                               const JudgeOptions& options);

}  // namespace ridgeline::evaluate
