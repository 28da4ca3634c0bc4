// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/edge_decision.h"

#include "evaluate/judge/image_evidence.h"
#include "evaluate/judge/plane_meeting.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace ridgeline::evaluate {
namespace {

struct Ridge {
  std::size_t a, b;
  PlaneMeeting meeting;
};

/// The pair of planes that meets along most of the line; among equals the pair that meets nearer to it in plan.
std::optional<Ridge> best_ridge(std::span<const CandidatePlane> candidates,
                                const Footprint& footprint,
                                const JudgeOptions& options) {
  std::optional<Ridge> best;
  const auto rank = [](const PlaneMeeting& m) {
    return std::pair(std::round(m.coverage * 10.0), -m.offset_m);
  };
  for (std::size_t a = 0; a < candidates.size(); ++a) {
    for (std::size_t b = a + 1; b < candidates.size(); ++b) {
      if (candidates[a].low_object || candidates[b].low_object) continue;
      const double angle = angle_between_rad(candidates[a].fit, candidates[b].fit);
      if (angle < options.ridge_angle_deg * kRadPerDeg) continue;
      const auto meeting = meeting_of(candidates[a], candidates[b], footprint, options);
      if (!meeting || meeting->offset_m > options.ridge_offset_m ||
          meeting->direction_rad > options.ridge_direction_deg * kRadPerDeg ||
          meeting->coverage < options.min_coverage) {
        continue;
      }
      if (!best || rank(*meeting) > rank(best->meeting)) best = Ridge{a, b, *meeting};
    }
  }
  return best;
}

std::string rounded_percent(double share) {
  std::ostringstream text;
  text << std::lround(100.0 * share) << " %";
  return text.str();
}

/// Whether the plane comes close enough to the line to have its edge there. A low object never does.
bool is_near(const CandidatePlane& plane, const JudgeOptions& options) {
  return !plane.low_object && plane.nearest_m <= options.step_offset_m;
}

/// Least coverage that a plane needs to judge: most of the best coverage of the planes near the line.
double least_coverage(std::span<const CandidatePlane> candidates, const JudgeOptions& options) {
  // a parked car is above the marking beside it, but accompanies only a part of it
  constexpr double kOfBest = 0.75;
  double best = 0.0;
  for (const CandidatePlane& p : candidates) {
    best = std::max(best, is_near(p, options) ? p.coverage : 0.0);
  }
  return std::max(options.min_coverage, kOfBest * best);
}

/// Whether surfaces above the chosen plane together accompany most of the line, and the images do not
/// show that the line is the chosen plane's. Such a line runs over the eaves of several roofs, of which
/// perhaps not all were found, and is the edge of no single surface.
bool runs_over_several(std::span<const CandidatePlane> candidates,
                       const CandidatePlane& chosen,
                       const Footprint& footprint,
                       const JudgeOptions& options,
                       const ImageEvidence& images) {
  constexpr double kAbove_m = 2.0;  // cars, hedges and walls are lower
  const double reach_m = 0.5 * options.corridor_half_width_m;
  std::vector<ZonePoint> above;
  double least_cost = HUGE_VAL;
  for (const CandidatePlane& plane : candidates) {
    const double step_m = height_at(plane.fit.plane, footprint.middle()) -
                          height_at(chosen.fit.plane, footprint.middle());
    if (!is_near(plane, options) || step_m < kAbove_m) continue;
    above.insert(above.end(), plane.beside.begin(), plane.beside.end());
    least_cost = std::min(least_cost, image_cost(images, plane.fit.plane));
  }
  return coverage_along(above, footprint.length_m, reach_m) >= options.min_coverage &&
         image_cost(images, chosen.fit.plane) > least_cost - kImageMargin;
}

/// Whether a plane has as many points to the inside of the line as to the outside.
bool is_inside(const CandidatePlane& plane,
               const Footprint& footprint,
               const JudgeOptions& options,
               const Eigen::Vector2d& inside) {
  const double side = footprint.across.dot(inside) < 0.0 ? -1.0 : 1.0;
  const auto beyond_gap = [&](double sign) {
    return std::ranges::count_if(
        plane.beside, [&](const ZonePoint& p) { return sign * p.t > options.side_gap_m; });
  };
  return beyond_gap(side) >= beyond_gap(-side);
}

/// The candidates that accompany the line and come close to it, the uppermost first; on the side `inside` if that is known.
std::vector<std::size_t> planes_along(std::span<const CandidatePlane> candidates,
                                      const Footprint& footprint,
                                      const JudgeOptions& options,
                                      const std::optional<Eigen::Vector2d>& inside) {
  const double least = inside ? options.min_coverage : least_coverage(candidates, options);
  std::vector<std::size_t> along;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const CandidatePlane& plane = candidates[i];
    if (!is_near(plane, options) || plane.coverage < least) continue;
    if (inside && !is_inside(plane, footprint, options, *inside)) continue;
    along.push_back(i);
  }
  const auto height = [&](std::size_t i) {
    return height_at(candidates[i].fit.plane, footprint.middle());
  };
  std::sort(along.begin(), along.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(-height(a), a) < std::pair(-height(b), b);
  });
  return along;
}

/// Whether both sides of the line carry the plane, so that the line runs inside it.
bool on_both_sides(const CandidatePlane& plane, const JudgeOptions& options) {
  const double gap = options.side_gap_m;
  const auto left = std::count_if(plane.beside.begin(), plane.beside.end(),
                                  [&](const ZonePoint& p) { return p.t > gap; });
  const auto right = std::count_if(plane.beside.begin(), plane.beside.end(),
                                   [&](const ZonePoint& p) { return p.t < -gap; });
  return 4 * std::min(left, right) >= std::max(left, right);
}

/// The plane whose edge the images show, among those `along` the line (the uppermost first). It is the
/// uppermost one if the images do not tell.
std::size_t plane_of_step(std::span<const CandidatePlane> candidates,
                          const std::vector<std::size_t>& along,
                          const std::optional<ImageEvidence>& images,
                          std::vector<std::string>& flags) {
  if (along.size() == 1) return along[0];
  if (!images) {
    flags.emplace_back("upper_plane");
    return along[0];
  }
  std::vector<std::pair<double, std::size_t>> costs;
  costs.reserve(along.size());
  for (const std::size_t i : along)
    costs.emplace_back(image_cost(*images, candidates[i].fit.plane), i);
  std::sort(costs.begin(), costs.end());
  if (costs[1].first - costs[0].first > kImageMargin) return costs[0].second;
  flags.emplace_back("plane_ambiguous");
  return along[0];
}

/// The plane that the images show the line on, if they show it on none of the planes `along` it. Such a
/// plane ends farther from the line than an edge may, or accompanies less of it: an overhang, a border
/// that the laser hit sparsely, a street beside a building that hides a part of it.
std::optional<std::size_t> seen_instead(std::span<const CandidatePlane> candidates,
                                        const std::vector<std::size_t>& along,
                                        const JudgeOptions& options,
                                        const ImageEvidence& images) {
  double cost = HUGE_VAL;
  for (const std::size_t i : along) {
    cost = std::min(cost, image_cost(images, candidates[i].fit.plane) - kImageMargin);
  }
  std::optional<std::size_t> seen;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const CandidatePlane& plane = candidates[i];
    if (plane.low_object || plane.coverage < options.min_coverage) continue;
    const double cost_of_this = image_cost(images, plane.fit.plane);
    if (cost_of_this >= cost) continue;
    cost = cost_of_this;
    seen = i;
  }
  return seen;
}

EdgeDecision step_decision(std::span<const CandidatePlane> candidates,
                           const Footprint& footprint,
                           const JudgeOptions& options,
                           const std::optional<ImageEvidence>& images,
                           const std::optional<Eigen::Vector2d>& inside) {
  const std::vector<std::size_t> along = planes_along(candidates, footprint, options, inside);
  EdgeDecision decision;
  if (along.empty()) {
    decision.status = Status::kLowCoverage;
    double most = 0.0;
    for (const CandidatePlane& plane : candidates) most = std::max(most, plane.coverage);
    decision.reason = "no plane accompanies the line closely enough: largest coverage " +
                      rounded_percent(most) + ", must be at least " +
                      rounded_percent(options.min_coverage);
    return decision;
  }
  const CandidatePlane& upper = candidates[along[0]];
  if (along.size() > 1) {
    // the surfaces have about one height, yet are neither one plane nor a ridge: nothing tells them apart
    constexpr double kSameHeight_m = 0.15;
    const CandidatePlane& second = candidates[along[1]];
    const double step_m = height_at(upper.fit.plane, footprint.middle()) -
                          height_at(second.fit.plane, footprint.middle());
    const double angle = angle_between_rad(upper.fit, second.fit);
    if (step_m < kSameHeight_m && angle >= options.ridge_angle_deg * kRadPerDeg) {
      decision.status = Status::kAmbiguous;
      decision.reason = "two planes of the same height at the line that do not meet along it";
      return decision;
    }
  }
  std::size_t chosen = plane_of_step(candidates, along, images, decision.flags);
  if (along.size() == 1 && images &&
      runs_over_several(candidates, candidates[chosen], footprint, options, *images)) {
    decision.status = Status::kAmbiguous;
    decision.reason = "surfaces above accompany most of the line, none of them along it all";
    return decision;
  }
  if (const auto seen = images ? seen_instead(candidates, along, options, *images) : std::nullopt) {
    chosen = *seen;
    decision.flags = {"seen_instead"};
  }
  if (on_both_sides(candidates[chosen], options)) decision.flags.emplace_back("merged");
  decision.status = Status::kEvaluated;
  decision.kind = Kind::kStep;
  decision.planes = {chosen};
  return decision;
}

}  // namespace

EdgeDecision decide_edge(std::span<const CandidatePlane> candidates,
                         const Footprint& footprint,
                         const JudgeOptions& options,
                         const std::optional<ImageEvidence>& images,
                         const std::optional<Eigen::Vector2d>& inside) {
  if (candidates.empty()) {
    EdgeDecision none;
    none.reason = "points beside the line, but no plane among them";
    return none;
  }
  const auto ridge = inside ? std::nullopt : best_ridge(candidates, footprint, options);
  if (ridge) {
    return {.status = Status::kEvaluated,
            .reason = "",
            .kind = Kind::kRidge,
            .planes = {ridge->a, ridge->b},
            .flags = {}};
  }
  return step_decision(candidates, footprint, options, images, inside);
}

}  // namespace ridgeline::evaluate
