// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/doubt.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace ridgeline::evaluate {
namespace {

constexpr double kAboveSurface_m = 0.2;  // a nearer point may belong to the chosen surface

/// Chi-square of the image segments against the chosen plane that suits them best, across the line and
/// for a pixel of noise; 0 if no plane can be compared.
double least_cost(std::span<const CandidatePlane> candidates,
                  const EdgeDecision& decision,
                  const ImageEvidence& images) {
  double least = HUGE_VAL;
  for (const std::size_t i : decision.planes) {
    const double cost = image_cost_parts(images, candidates[i].fit.plane).across;
    if (std::isfinite(cost)) least = std::min(least, cost);
  }
  return std::isfinite(least) ? least : 0.0;
}

/// A point beside the line, compared with the planes.
struct Placed {
  double t_m;
  double above_m;  ///< above the highest of the chosen planes, at right angles
  bool explained;  ///< whether any plane explains the point
};

std::vector<Placed> place(std::span<const ZonePoint> zone,
                          std::span<const CandidatePlane> candidates,
                          const EdgeDecision& decision,
                          const Footprint& footprint,
                          const JudgeOptions& options) {
  std::vector<Placed> placed;
  for (const ZonePoint& p : zone) {
    if (std::abs(p.t) > options.corridor_half_width_m || p.s < 0.0 || p.s > footprint.length_m) {
      continue;
    }
    Placed point{p.t, HUGE_VAL, false};
    point.explained =
        std::any_of(candidates.begin(), candidates.end(), [&](const CandidatePlane& plane) {
          return plane.fit.plane.absDistance(p.x) <= 1.5 * options.inlier_distance_m;
        });
    for (const std::size_t i : decision.planes) {
      point.above_m = std::min(point.above_m, candidates[i].fit.plane.signedDistance(p.x));
    }
    placed.push_back(point);
  }
  return placed;
}

/// How many points raise a doubt: at least a number, and more than a share of all points near the line.
struct Least {
  std::size_t n;
  double share;
};

/// Whether enough unexplained points within a distance of the line satisfy a condition.
template <typename Condition>
bool exceeds(const Least& least,
             std::span<const Placed> points,
             double within_m,
             const Condition& condition) {
  std::size_t n = 0;
  std::size_t of = 0;
  for (const Placed& point : points) {
    if (std::abs(point.t_m) > within_m) continue;
    ++of;
    n += !point.explained && condition(point) ? 1 : 0;
  }
  return n >= least.n && static_cast<double>(n) > least.share * static_cast<double>(of);
}

/// Whether there are points on one side only, and so many that this is no chance.
bool one_side_is_empty(std::span<const Placed> points, const JudgeOptions& options) {
  std::size_t left = 0;
  std::size_t right = 0;
  for (const Placed& point : points) {
    left += point.t_m > options.side_gap_m ? 1 : 0;
    right += point.t_m < -options.side_gap_m ? 1 : 0;
  }
  return std::min(left, right) == 0 &&
         2 * std::max(left, right) >= static_cast<std::size_t>(options.min_points);
}

/// The largest standard deviation of a chosen plane at the middle of the line.
double largest_sigma_m(std::span<const CandidatePlane> candidates,
                       const EdgeDecision& decision,
                       const Footprint& footprint) {
  const Eigen::Vector2d middle = footprint.middle();
  double largest = 0.0;
  for (const std::size_t i : decision.planes) {
    const PlaneFit& fit = candidates[i].fit;
    const Eigen::Vector3d on_plane(middle.x(), middle.y(), height_at(fit.plane, middle));
    largest = std::max(largest, fit.sigma_at(on_plane));
  }
  return largest;
}

}  // namespace

bool is_contradicted(std::span<const CandidatePlane> candidates,
                     const EdgeDecision& decision,
                     const std::optional<ImageEvidence>& images) {
  constexpr double kFivePixels = 25.0;  // chi-square of 5 px at one end, or of 3.5 px at both
  return images && least_cost(candidates, decision, *images) > kFivePixels;
}

std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   const EdgeDecision& decision,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options) {
  // a plane must be known as well as by this many laser points on the line; three make a plane
  constexpr double kFewestPoints = 3.0;
  const double known_to_m = options.lidar_sigma_m / std::sqrt(kFewestPoints);
  const double sigma_m = largest_sigma_m(candidates, decision, footprint);
  if (sigma_m <= known_to_m) return std::nullopt;
  std::ostringstream reason;
  reason << std::setprecision(3) << "its plane is known to " << sigma_m
         << " m at the line, must be known to " << known_to_m << " m";
  return reason.str();
}

std::optional<std::string> reason_for_doubt(std::span<const ZonePoint> zone,
                                            std::span<const CandidatePlane> candidates,
                                            const EdgeDecision& decision,
                                            const Footprint& footprint,
                                            const std::optional<ImageEvidence>& images,
                                            const JudgeOptions& options) {
  constexpr double kCanopy_m = 2.0;       // points farther up hide no edge that the images show
  constexpr Least kHedge{4, 0.15};        // a parapet of 0.3 m within 0.8 m on both sides
  constexpr Least kFence{4, 0.1};         // fewer are birds and antennas
  constexpr Least kFenceSeenOff{2, 0.1};  // for a line that the images show off the surface
  constexpr double kFence_m = 0.3;        // across; the line of a fence may be off by that in plan
  constexpr double kThreePixels = 9.0;    // chi-square of 3 px at one end, or of 2.1 px at both
  if (auto reason = reason_too_little_known(candidates, decision, footprint, options)) {
    return reason;
  }
  const std::vector<Placed> points = place(zone, candidates, decision, footprint, options);
  const auto stands = [](const Placed& point) {
    return point.above_m > kAboveSurface_m && point.above_m < kCanopy_m;
  };
  const bool seen_off_surface = images && least_cost(candidates, decision, *images) > kThreePixels;
  if (exceeds(kHedge, points, options.step_offset_m, stands) ||
      exceeds(seen_off_surface ? kFenceSeenOff : kFence, points, kFence_m, stands)) {
    return "points stand along the line on the surface that it would be judged by";
  }
  if (!is_contradicted(candidates, decision, images)) return std::nullopt;
  const auto apart = [](const Placed& point) { return std::abs(point.above_m) > kAboveSurface_m; };
  if (exceeds(kHedge, points, options.step_offset_m, apart) ||
      exceeds(kHedge, points, options.corridor_half_width_m, apart)) {
    return "the images show the line on no plane, and no plane explains the points beside it";
  }
  if (one_side_is_empty(points, options)) {
    return "the images show the line on no plane, and the cloud is empty on one side of it";
  }
  return std::nullopt;
}

}  // namespace ridgeline::evaluate
