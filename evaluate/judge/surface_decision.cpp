// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/surface_decision.h"

#include "evaluate/judge/image_evidence.h"
#include "evaluate/judge/surface_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ridgeline::evaluate {
namespace {

/// Mean over the line of the squared distance from the planes of a hypothesis, over its variance.
double place_chi_square(const SurfaceHypothesis& h,
                        std::span<const CandidatePlane> candidates,
                        const Segment3& segment,
                        const JudgeOptions& options) {
  double sum = 0.0;
  for (const std::size_t i : h.planes) {
    const PlaneFit& fit = candidates[i].fit;
    const double sigma_m = std::hypot(options.place_sigma_m, fit.sigma_at(midpoint(segment)));
    sum += std::pow(orthogonal_distance(segment, fit.plane).rms / sigma_m, 2);
  }
  return sum / static_cast<double>(h.planes.size());
}

double log_place(const SurfaceHypothesis& h,
                 std::span<const CandidatePlane> candidates,
                 const Segment3& segment,
                 const JudgeOptions& options) {
  // density of a right line at its distance, in units of that of a wrong line that may be anywhere
  const double wrong =
      kWrongDensityPerMetre * options.place_sigma_m * std::sqrt(2.0 * std::numbers::pi);
  if (h.planes.empty()) return std::log(wrong);
  return std::log(std::exp(-0.5 * place_chi_square(h, candidates, segment, options)) + wrong);
}

double log_images(const SurfaceHypothesis& h,
                  std::span<const CandidatePlane> candidates,
                  const ImageEvidence& images,
                  const JudgeOptions& options) {
  double sum = 0.0;
  for (const std::size_t i : h.planes) {
    sum += sightings_chi_square(images, candidates[i].fit.plane, options.sigma_edge_px);
  }
  if (h.planes.empty()) {
    return kObjectSeen -
           0.5 * kSightingWeight * sightings_chi_square(images, options.sigma_edge_px);
  }
  return -0.5 * kSightingWeight * sum / static_cast<double>(h.planes.size());
}

constexpr std::array kOrder{DecidedBy::kPlan, DecidedBy::kImages, DecidedBy::kPoints,
                            DecidedBy::kPlace};

/// The sum of the evidence in kOrder, up to and with one kind.
double up_to(const SurfaceEvidence& e, DecidedBy last) {
  const std::array parts{e.plan, e.images, e.points, e.place};
  const auto n = static_cast<std::ptrdiff_t>(last) + 1;
  return std::accumulate(parts.begin(), parts.begin() + n, 0.0);
}

std::vector<double> probabilities(std::span<const SurfaceEvidence> evidence, DecidedBy last) {
  std::vector<double> p;
  p.reserve(evidence.size());
  for (const SurfaceEvidence& e : evidence) p.push_back(up_to(e, last));
  const double most = *std::ranges::max_element(p);
  double sum = 0.0;
  for (double& value : p) sum += value = std::exp(value - most);
  for (double& value : p) value /= sum;
  return p;
}

/// Whether two hypotheses give a line the same distance.
bool are_one_surface(const SurfaceHypothesis& a, const SurfaceHypothesis& b) {
  constexpr double kSame_m = 0.15;
  if (a.surface == Surface::kObject || b.surface == Surface::kObject) return a.surface == b.surface;
  return (a.heights_m - b.heights_m).cwiseAbs().maxCoeff() <= kSame_m;
}

/// Probability of the surface of a hypothesis.
double probability_of(std::size_t chosen,
                      std::span<const SurfaceHypothesis> hypotheses,
                      std::span<const double> p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (are_one_surface(hypotheses[chosen], hypotheses[i])) sum += p[i];
  }
  return sum;
}

/// The first kind of evidence from which on the surface stays probable, whatever is added.
DecidedBy decided_by(std::size_t chosen,
                     std::span<const SurfaceHypothesis> hypotheses,
                     std::span<const SurfaceEvidence> evidence,
                     const JudgeOptions& options) {
  DecidedBy first = DecidedBy::kPlace;
  for (std::size_t k = kOrder.size(); k-- > 0;) {
    const std::vector<double> p = probabilities(evidence, kOrder[k]);
    if (probability_of(chosen, hypotheses, p) < options.min_probability) break;
    first = kOrder[k];
  }
  return first;
}

/// The most probable hypothesis of another surface.
std::optional<std::size_t> next_surface(std::size_t chosen,
                                        std::span<const SurfaceHypothesis> hypotheses,
                                        std::span<const double> p) {
  std::optional<std::size_t> next;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (are_one_surface(hypotheses[chosen], hypotheses[i])) continue;
    if (!next || p[i] > p[*next]) next = i;
  }
  return next;
}

const char* words(Surface surface) {
  switch (surface) {
    case Surface::kUpper:
      return "the upper surface";
    case Surface::kLower:
      return "a lower surface";
    case Surface::kGround:
      return "the ground";
    case Surface::kRidge:
      return "two planes that meet";
    case Surface::kObject:
      return "an object without a plane";
  }
  return "nothing";
}

/// Whether both sides of the line carry the plane, so that the line runs inside it.
bool runs_inside(const CandidatePlane& plane, const JudgeOptions& options) {
  const double gap = options.side_gap_m;
  const auto left =
      std::ranges::count_if(plane.beside, [&](const ZonePoint& p) { return p.t > gap; });
  const auto right =
      std::ranges::count_if(plane.beside, [&](const ZonePoint& p) { return p.t < -gap; });
  return 4 * std::min(left, right) >= std::max(left, right);
}

SurfaceDecision without_plane(std::span<const CandidatePlane> candidates,
                              const JudgeOptions& options) {
  SurfaceDecision decision;
  if (candidates.empty()) {
    decision.reason = "points beside the line, but no plane among them";
    return decision;
  }
  double most = 0.0;
  for (const CandidatePlane& plane : candidates) most = std::max(most, plane.coverage);
  decision.status = Status::kLowCoverage;
  decision.reason = fmt::format(
      "no plane accompanies the line closely enough: largest coverage {:.0f} %, must be at least "
      "{:.0f} %",
      100.0 * most, 100.0 * options.min_coverage);
  return decision;
}

}  // namespace

std::vector<SurfaceEvidence> surface_evidence(std::span<const SurfaceHypothesis> hypotheses,
                                              std::span<const CandidatePlane> candidates,
                                              const Segment3& segment,
                                              const std::optional<ImageEvidence>& images,
                                              const JudgeOptions& options) {
  const bool seen = images && has_independent_sighting(*images);
  std::vector<SurfaceEvidence> all;
  all.reserve(hypotheses.size());
  for (const SurfaceHypothesis& h : hypotheses) {
    SurfaceEvidence e;
    e.plan = std::inner_product(h.plan.begin(), h.plan.end(), kPlanWeights.begin(), 0.0);
    e.points = kAccompaniedWeight * h.accompanied;
    if (seen) {
      e.images = log_images(h, candidates, *images, options);
    } else {
      e.place = log_place(h, candidates, segment, options);
    }
    all.push_back(e);
  }
  return all;
}

SurfaceDecision decide_surface(std::span<const ZonePoint> zone,
                               std::span<const CandidatePlane> candidates,
                               const Footprint& footprint,
                               const JudgedLine& line,
                               const JudgeOptions& options) {
  const std::vector<SurfaceHypothesis> hypotheses =
      surface_hypotheses(zone, candidates, footprint, line.segment, line.inside, options);
  if (hypotheses.size() == 1) return without_plane(candidates, options);
  const std::vector<SurfaceEvidence> evidence =
      surface_evidence(hypotheses, candidates, line.segment, line.images, options);
  const std::vector<double> p = probabilities(evidence, DecidedBy::kPlace);
  std::vector<double> of_surface;
  for (std::size_t i = 0; i < p.size(); ++i) of_surface.push_back(probability_of(i, hypotheses, p));
  const double most = *std::ranges::max_element(of_surface);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (of_surface[i] >= most && (of_surface[chosen] < most || p[i] > p[chosen])) chosen = i;
  }
  const std::optional<std::size_t> next = next_surface(chosen, hypotheses, p);

  SurfaceDecision decision;
  decision.surface = hypotheses[chosen].surface;
  decision.probability = of_surface[chosen];
  if (next) decision.other = hypotheses[*next].surface;
  if (of_surface[chosen] < options.min_probability) {
    decision.status = Status::kAmbiguous;
    decision.reason =
        fmt::format("{} with a probability of {:.2f}, or {}", words(*decision.surface),
                    *decision.probability, next ? words(*decision.other) : "nothing");
    return decision;
  }
  if (hypotheses[chosen].surface == Surface::kObject) {
    decision.reason =
        "the edge of a car, a hedge or another object that the cloud has no plane for";
    return decision;
  }
  decision.status = Status::kEvaluated;
  decision.planes = hypotheses[chosen].planes;
  decision.kind = decision.planes.size() == 2 ? Kind::kRidge : Kind::kStep;
  decision.decided_by = decided_by(chosen, hypotheses, evidence, options);
  if (decision.kind == Kind::kStep && runs_inside(candidates[decision.planes[0]], options)) {
    decision.flags.emplace_back("merged");
  }
  return decision;
}

}  // namespace ridgeline::evaluate
