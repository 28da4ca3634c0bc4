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

/// Mean over the line of the squared distance from the planes of a hypothesis, divided by its
/// variance.
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

/// Densities of the distance of a line from its surface, relative to that of a correct line that
/// lies on a plane.
struct PlaceDensities {
  double wrong;   ///< of a wrong line, which may be anywhere
  double object;  ///< of the edge of an object, which lies within kMaxObjectDistance_m of a plane
};

PlaceDensities place_densities(const JudgeOptions& options) {
  const double width_m = options.place_sigma_m * std::sqrt(2.0 * std::numbers::pi);
  return {kWrongDensityPerMetre * width_m, width_m / (2.0 * kMaxObjectDistance_m)};
}

double log_place(const SurfaceHypothesis& h,
                 std::span<const CandidatePlane> candidates,
                 const Segment3& segment,
                 const JudgeOptions& options) {
  return std::log(std::exp(-0.5 * place_chi_square(h, candidates, segment, options)) +
                  place_densities(options).wrong);
}

/// For an object: what has no plane in the cloud lies near something that has one, or has some
/// points.
double log_place_of_object(std::span<const SurfaceHypothesis> hypotheses,
                           std::span<const CandidatePlane> candidates,
                           const Segment3& segment,
                           const JudgeOptions& options) {
  const auto is_near = [&](const SurfaceHypothesis& h) {
    return h.has_points || std::ranges::any_of(h.planes, [&](std::size_t i) {
             const double mean_m = orthogonal_distance(segment, candidates[i].fit.plane).mean;
             return std::abs(mean_m) < kMaxObjectDistance_m;
           });
  };
  const PlaceDensities densities = place_densities(options);
  return std::ranges::any_of(hypotheses, is_near) ? std::log(densities.object)
                                                  : 2.0 * std::log(densities.wrong);
}

double log_images(const SurfaceHypothesis& h,
                  std::span<const CandidatePlane> candidates,
                  const ImageEvidence& images,
                  const JudgeOptions& options) {
  double sum = 0.0;
  for (const std::size_t i : h.planes) {
    sum += observations_chi_square(images, candidates[i].fit.plane, options.sigma_edge_px);
  }
  if (h.planes.empty()) {
    return std::log(place_densities(options).object) -
           0.5 * observations_chi_square(images, options.sigma_edge_px);
  }
  return -0.5 * sum / static_cast<double>(h.planes.size());
}

constexpr std::array kOrder{DecidedBy::kPlan, DecidedBy::kImages, DecidedBy::kPoints,
                            DecidedBy::kPlace};

/// The sum of the evidence in kOrder, up to and including one kind.
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

/// Whether two hypotheses give the same distance of a line.
bool are_one_surface(const SurfaceHypothesis& a, const SurfaceHypothesis& b) {
  constexpr double kSame_m = 0.15;
  if (a.surface == JudgingSurface::kObject || b.surface == JudgingSurface::kObject)
    return a.surface == b.surface;
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

/// Probability that a line lies on none of the surfaces of which it may be an edge.
double probability_of_wrong(std::span<const SurfaceEvidence> evidence, std::span<const double> p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * evidence[i].wrong;
  return sum;
}

/// The most probable hypothesis of the most probable surface.
std::size_t likeliest(std::span<const SurfaceHypothesis> hypotheses,
                      std::span<const double> p,
                      bool objects_too) {
  std::optional<std::size_t> best;
  double most = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!objects_too && hypotheses[i].surface == JudgingSurface::kObject) continue;
    const double of_surface = probability_of(i, hypotheses, p);
    if (best && (of_surface < most || (of_surface == most && p[i] <= p[*best]))) continue;
    best = i;
    most = of_surface;
  }
  return *best;
}

/// The first kind of evidence from which on the surface remains probable, whatever is added.
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

const char* words(JudgingSurface surface) {
  switch (surface) {
    case JudgingSurface::kUpper:
      return "the upper surface";
    case JudgingSurface::kLower:
      return "a lower surface";
    case JudgingSurface::kGround:
      return "the ground";
    case JudgingSurface::kRidge:
      return "two planes that meet";
    case JudgingSurface::kObject:
      return "an object without a plane";
  }
  return "nothing";
}

/// Whether the plane has points on both sides of the line, so that the line runs inside it.
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
    decision.reason = "points next to the line, but no plane in them";
    return decision;
  }
  double most = 0.0;
  for (const CandidatePlane& plane : candidates) most = std::max(most, plane.coverage);
  decision.status = Status::kLowCoverage;
  decision.reason = fmt::format(
      "no plane covers enough of the line: largest coverage {:.0f} %, must be at least {:.0f} %",
      100.0 * most, 100.0 * options.min_coverage);
  return decision;
}

}  // namespace

std::vector<SurfaceEvidence> surface_evidence(std::span<const SurfaceHypothesis> hypotheses,
                                              std::span<const CandidatePlane> candidates,
                                              const Segment3& segment,
                                              const std::optional<ImageEvidence>& images,
                                              const JudgeOptions& options) {
  const bool seen = images && has_independent_observation(*images);
  std::vector<SurfaceEvidence> all;
  all.reserve(hypotheses.size());
  for (const SurfaceHypothesis& h : hypotheses) {
    SurfaceEvidence e;
    e.plan = std::inner_product(h.plan.begin(), h.plan.end(), kPlanWeights.begin(), 0.0);
    e.points = kAccompaniedWeight * h.accompanied;
    if (seen) {
      e.images = log_images(h, candidates, *images, options);
    } else if (h.planes.empty()) {
      e.place = log_place_of_object(hypotheses, candidates, segment, options);
    } else {
      e.place = log_place(h, candidates, segment, options);
      e.wrong = place_densities(options).wrong / std::exp(e.place);
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
  const bool is_far = probability_of_wrong(evidence, p) >= options.min_probability;
  const std::size_t chosen = likeliest(hypotheses, p, !is_far);
  const std::optional<std::size_t> next = next_surface(chosen, hypotheses, p);

  SurfaceDecision decision;
  decision.surface = hypotheses[chosen].surface;
  decision.probability = probability_of(chosen, hypotheses, p);
  if (next) decision.other = hypotheses[*next].surface;
  if (!is_far && *decision.probability < options.min_probability) {
    decision.status = Status::kAmbiguous;
    decision.reason =
        fmt::format("{} with a probability of {:.2f}, or {}", words(*decision.surface),
                    *decision.probability, next ? words(*decision.other) : "nothing");
    return decision;
  }
  if (hypotheses[chosen].surface == JudgingSurface::kObject) {
    decision.reason = "the edge of a car, a hedge or another object without a plane in the cloud";
    return decision;
  }
  decision.status = Status::kEvaluated;
  decision.is_far = is_far;
  decision.planes = hypotheses[chosen].planes;
  decision.kind = decision.planes.size() == 2 ? Kind::kRidge : Kind::kStep;
  decision.decided_by = decided_by(chosen, hypotheses, evidence, options);
  if (decision.kind == Kind::kStep && runs_inside(candidates[decision.planes[0]], options)) {
    decision.flags.emplace_back("merged");
  }
  return decision;
}

}  // namespace ridgeline::evaluate
