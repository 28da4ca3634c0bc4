// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/surface_hypotheses.h"

#include "evaluate/judge/plane_meeting.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/median.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr double kHigher_m =
    0.3;  // a surface that is higher by less than this is the same one, or hides nothing
constexpr double kStorey_m = 2.0;

// Limits between a line and the intersection line of a ridge's planes, in plan: the largest
// distance, at both ends, and the largest angle (calibration.md, thresholds of the judge).
constexpr double kMaxRidgeOffset_m = 1.0;
constexpr double kMaxRidgeDirection_deg = 15.0;

/// How far a plane's points extend across a line, for each stretch along it; HUGE_VAL and -HUGE_VAL
/// if a stretch has no points.
struct Reach {
  std::vector<double> lowest_t, highest_t;
};

class Stretches {
 public:
  /// A line of 5 m has five stretches of 1 m, regardless of how its coordinates are rounded.
  static constexpr double kRounding = 1e-6;

  Stretches(double length_m, double spacing_m)
      : length_m_(length_m),
        n_(static_cast<std::size_t>(
            std::max(1.0, std::floor(length_m / std::max(1.0, 2.0 * spacing_m) + kRounding)))) {}

  [[nodiscard]] std::size_t n() const { return n_; }
  [[nodiscard]] double middle_m(std::size_t i) const {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(n_) * length_m_;
  }
  [[nodiscard]] Reach reach_of(std::span<const ZonePoint> points) const {
    Reach reach{std::vector<double>(n_, HUGE_VAL), std::vector<double>(n_, -HUGE_VAL)};
    for (const ZonePoint& p : points) {
      const double place = std::floor(p.s / length_m_ * static_cast<double>(n_));
      if (place < 0.0 || place >= static_cast<double>(n_)) continue;
      const auto i = static_cast<std::size_t>(place);
      reach.lowest_t[i] = std::min(reach.lowest_t[i], p.t);
      reach.highest_t[i] = std::max(reach.highest_t[i], p.t);
    }
    return reach;
  }

 private:
  double length_m_;
  std::size_t n_;
};

/// How far the plane continues beyond the line, on the side with fewer of its points; negative if
/// it ends before the line.
double beyond_line_m(const CandidatePlane& plane, const Reach& reach) {
  std::ptrdiff_t more_left = 0;
  for (const ZonePoint& p : plane.beside) more_left += p.t > 0.0 ? 1 : -1;
  std::vector<double> beyond;
  for (std::size_t i = 0; i < reach.lowest_t.size(); ++i) {
    if (reach.lowest_t[i] > reach.highest_t[i]) continue;
    beyond.push_back(more_left > 0 ? -reach.lowest_t[i] : reach.highest_t[i]);
  }
  return beyond.empty() ? -HUGE_VAL : upper_median(std::move(beyond));
}

/// A candidate and its position in plan and height relative to the line and the other candidates.
struct PlacedPlane {
  std::size_t candidate;
  Reach reach;
  double beyond_m;
  double height_m;  ///< at the middle of the line
};

/// Share of the line over which one of the higher planes extends.
double covered_share(const PlacedPlane& plane,
                     std::span<const PlacedPlane> all,
                     const Stretches& stretches) {
  constexpr double kBeyond_m = 0.15;
  std::size_t n = 0;
  for (std::size_t i = 0; i < stretches.n(); ++i) {
    n += std::ranges::any_of(all,
                             [&](const PlacedPlane& other) {
                               return other.height_m > plane.height_m + kHigher_m &&
                                      other.reach.lowest_t[i] < -kBeyond_m &&
                                      other.reach.highest_t[i] > kBeyond_m;
                             })
             ? 1
             : 0;
  }
  return static_cast<double>(n) / static_cast<double>(stretches.n());
}

constexpr double kNotOn = 1.5;  // times the inlier distance

/// Whether no candidate explains a point beside the line.
bool is_unexplained(const ZonePoint& p,
                    std::span<const CandidatePlane> candidates,
                    const JudgeOptions& options) {
  return std::ranges::none_of(candidates, [&](const CandidatePlane& plane) {
    return plane.fit.plane.absDistance(p.x) <= kNotOn * options.inlier_distance_m;
  });
}

struct PointsBeside {
  std::vector<ZonePoint> unexplained;
  std::size_t n_beside = 0, n_in = 0;  ///< number of all points within kBeside_m and kIn_m
  bool one_side_empty = false;
};
constexpr double kBeside_m = 0.8;
constexpr double kIn_m = 0.3;

PointsBeside points_beside_line(std::span<const ZonePoint> zone,
                                std::span<const CandidatePlane> candidates,
                                const Footprint& footprint,
                                const JudgeOptions& options) {
  PointsBeside beside;
  std::size_t left = 0;
  std::size_t right = 0;
  for (const ZonePoint& p : zone) {
    if (p.s < 0.0 || p.s > footprint.length_m || std::abs(p.t) > options.corridor_half_width_m) {
      continue;
    }
    left += p.t > options.side_gap_m ? 1 : 0;
    right += p.t < -options.side_gap_m ? 1 : 0;
    if (std::abs(p.t) > kBeside_m) continue;
    ++beside.n_beside;
    beside.n_in += std::abs(p.t) <= kIn_m ? 1 : 0;
    if (is_unexplained(p, candidates, options)) beside.unexplained.push_back(p);
  }
  beside.one_side_empty = std::min(left, right) == 0 &&
                          2 * std::max(left, right) >= static_cast<std::size_t>(options.min_points);
  return beside;
}

/// Share of the points within a distance of the line that no plane explains and that stand on the
/// surface.
double standing_share(const PointsBeside& beside,
                      const Plane3& plane,
                      double within_m,
                      std::size_t of) {
  constexpr double kMinHeightAbove_m = 0.2;  // a closer point may belong to the surface
  constexpr double kMaxHeightAbove_m = 2.0;  // points higher up, in canopies, hide no edge
  const auto n = std::ranges::count_if(beside.unexplained, [&](const ZonePoint& p) {
    const double above_m = plane.signedDistance(p.x);
    return std::abs(p.t) <= within_m && above_m > kMinHeightAbove_m && above_m < kMaxHeightAbove_m;
  });
  return of == 0 ? 0.0 : static_cast<double>(n) / static_cast<double>(of);
}

/// Share of the line that has unexplained points near it in space.
double accompanied_share(const PointsBeside& beside,
                         const Segment3& segment,
                         double length_m,
                         double reach_m) {
  constexpr double kNear_m = 0.3;
  std::vector<ZonePoint> near;
  for (const ZonePoint& p : beside.unexplained) {
    if (distance(segment, p.x) <= kNear_m) near.push_back(p);
  }
  return coverage_along(near, length_m, reach_m);
}

/// Whether a plane has points next to the line on its inner side, at least half as many as on its
/// outer side. A roof continues behind a dormer, so points farther away are no evidence.
bool lies_inside(const CandidatePlane& plane,
                 const Footprint& footprint,
                 const JudgeOptions& options,
                 const Eigen::Vector2d& inside) {
  const double side = footprint.across.dot(inside) < 0.0 ? -1.0 : 1.0;
  constexpr double kNext_m = 1.0;
  const auto next_to_line = [&](double sign) {
    return std::ranges::count_if(plane.beside, [&](const ZonePoint& p) {
      return sign * p.t > options.side_gap_m && sign * p.t <= options.side_gap_m + kNext_m;
    });
  };
  const auto n_inside = next_to_line(side);
  return n_inside > 0 && 2 * n_inside >= next_to_line(-side);
}

Eigen::Vector2d heights_at_ends(const Plane3& plane, const Footprint& footprint) {
  return {height_at(plane, footprint.start), height_at(plane, footprint.at(footprint.length_m))};
}

/// Splits the value 1 between the two knots next to the position of the border.
void add_border(double beyond_m, std::size_t first_term, SurfaceHypothesis& h) {
  const double x = std::clamp(beyond_m, kBorders_m.front(), kBorders_m.back());
  std::size_t i = 0;
  while (i + 2 < kBorders_m.size() && x > kBorders_m[i + 1]) ++i;
  const double share = (x - kBorders_m[i]) / (kBorders_m[i + 1] - kBorders_m[i]);
  h.plan[first_term + i] = 1.0 - share;
  h.plan[first_term + i + 1] = share;
}

class Hypotheses {
 public:
  Hypotheses(std::span<const ZonePoint> zone,
             std::span<const CandidatePlane> candidates,
             const Footprint& footprint,
             const JudgeOptions& options)
      : candidates_(candidates),
        footprint_(footprint),
        options_(options),
        spacing_m_(
            std::min(1.0,
                     point_spacing_m(zone.size(),
                                     2.0 * options.fit_half_width_m *
                                         (footprint.length_m + 2.0 * options.fit_half_width_m)))),
        stretches_(footprint.length_m, spacing_m_),
        beside_(points_beside_line(zone, candidates, footprint, options)) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].coverage < options.min_coverage) continue;
      Reach reach = stretches_.reach_of(candidates[i].beside);
      const double beyond_m = beyond_line_m(candidates[i], reach);
      placed_.push_back(
          {i, std::move(reach), beyond_m, height_at(candidates[i].fit.plane, footprint.middle())});
    }
  }

  [[nodiscard]] SurfaceHypothesis object(std::span<const ZonePoint> zone,
                                         const Segment3& segment) const {
    SurfaceHypothesis h;
    h.plan[kShort] = 1.0 / std::max(1.0, footprint_.length_m);
    h.plan[kOneSideEmpty] = beside_.one_side_empty ? 1.0 : 0.0;
    h.accompanied = accompanied_share(beside_, segment, footprint_.length_m, spacing_m_);
    h.has_points = std::ranges::any_of(zone, [&](const ZonePoint& p) {
      constexpr double kNear_m = 1.0;
      return distance(segment, p.x) <= kNear_m &&
             std::ranges::none_of(placed_, [&](const auto& of) {
               return candidates_[of.candidate].fit.plane.absDistance(p.x) <=
                      kNotOn * options_.inlier_distance_m;
             });
    });
    return h;
  }

  [[nodiscard]] std::vector<SurfaceHypothesis> steps(
      const std::optional<Eigen::Vector2d>& inside) const {
    std::vector<SurfaceHypothesis> all;
    for (const PlacedPlane& plane : placed_) {
      const CandidatePlane& candidate = candidates_[plane.candidate];
      if (inside && !lies_inside(candidate, footprint_, options_, *inside)) continue;
      all.push_back(step(plane));
    }
    return all;
  }

  [[nodiscard]] std::vector<SurfaceHypothesis> meetings() const {
    std::vector<SurfaceHypothesis> all;
    for (std::size_t a = 0; a < candidates_.size(); ++a) {
      for (std::size_t b = a + 1; b < candidates_.size(); ++b) {
        const double angle = angle_between_rad(candidates_[a].fit, candidates_[b].fit);
        if (angle < kMinAngleOfRidge_deg * kRadPerDeg) continue;
        const auto meeting = meeting_of(candidates_[a], candidates_[b], footprint_, options_);
        if (!meeting || meeting->offset_m > kMaxRidgeOffset_m ||
            meeting->direction_rad > kMaxRidgeDirection_deg * kRadPerDeg ||
            meeting->coverage < options_.min_coverage) {
          continue;
        }
        all.push_back(meeting_hypothesis(a, b, *meeting, angle));
      }
    }
    return all;
  }

 private:
  [[nodiscard]] SurfaceHypothesis step(const PlacedPlane& plane) const {
    const CandidatePlane& candidate = candidates_[plane.candidate];
    const bool is_lower = std::ranges::any_of(placed_, [&](const PlacedPlane& other) {
      return other.height_m > plane.height_m + kHigher_m;
    });
    const bool is_ground =
        is_lower &&
        std::ranges::none_of(placed_,
                             [&](const PlacedPlane& o) { return o.height_m < plane.height_m; }) &&
        std::ranges::any_of(
            placed_, [&](const PlacedPlane& o) { return o.height_m > plane.height_m + kStorey_m; });
    SurfaceHypothesis h;
    h.surface = is_ground  ? JudgingSurface::kGround
                : is_lower ? JudgingSurface::kLower
                           : JudgingSurface::kUpper;
    h.planes = {plane.candidate};
    h.heights_m = heights_at_ends(candidate.fit.plane, footprint_);
    // points end before the border of their plane, on average by half their spacing over a stretch
    add_border(plane.beyond_m + 0.25 * spacing_m_, is_lower ? kLowerBorder : kUpperBorder, h);
    h.plan[kIsGround] = is_ground ? 1.0 : 0.0;
    add_step_above(plane, h);
    h.plan[kCovered] = is_lower ? covered_share(plane, placed_, stretches_) : 0.0;
    h.plan[kMissing] = 1.0 - candidate.coverage;
    h.plan[kFewPoints] = 1.0 / std::sqrt(candidate.fit.n);
    if (is_lower) h.plan[kLowerFewPoints] = h.plan[kFewPoints];
    h.plan[kIsLedge] = candidate.fit.spread_m2.y() == HUGE_VAL ? 1.0 : 0.0;
    add_points(candidate.fit.plane, is_lower, h);
    return h;
  }

  [[nodiscard]] SurfaceHypothesis meeting_hypothesis(std::size_t a,
                                                     std::size_t b,
                                                     const PlaneMeeting& meeting,
                                                     double angle_rad) const {
    SurfaceHypothesis h;
    h.surface = JudgingSurface::kRidge;
    h.planes = {a, b};
    h.heights_m = 0.5 * (heights_at_ends(candidates_[a].fit.plane, footprint_) +
                         heights_at_ends(candidates_[b].fit.plane, footprint_));
    h.plan[kIsMeeting] = 1.0;
    h.plan[kMeetingOffset] = meeting.offset_m;
    h.plan[kMeetingDirection] = meeting.direction_rad;
    h.plan[kMeetingMissing] = 1.0 - meeting.coverage;
    h.plan[kMeetingFlat] = kMinAngleOfRidge_deg * kRadPerDeg / angle_rad;
    const PlacedPlane middle{a, {}, 0.0, h.heights_m.mean()};
    h.plan[kCovered] = covered_share(middle, placed_, stretches_);
    add_points(candidates_[a].fit.plane, false, h);
    return h;
  }

  /// Whether the point lies under a plane or its border, like the returns of a wall. Such points
  /// stand on no surface.
  [[nodiscard]] bool is_on_wall(const ZonePoint& p) const {
    constexpr double kUnder_m = 0.2;
    constexpr double kBeyondBorder_m = 0.3;
    return std::ranges::any_of(placed_, [&](const PlacedPlane& plane) {
      return p.t > std::ranges::min(plane.reach.lowest_t) - kBeyondBorder_m &&
             p.t < std::ranges::max(plane.reach.highest_t) + kBeyondBorder_m &&
             height_at(candidates_[plane.candidate].fit.plane, p.x.head<2>()) > p.x.z() + kUnder_m;
    });
  }

  /// The terms of a plane that depend on the next higher one.
  void add_step_above(const PlacedPlane& plane, SurfaceHypothesis& h) const {
    constexpr double kAtBorder_m = 0.3;
    const PlacedPlane* next = nullptr;
    for (const PlacedPlane& other : placed_) {
      if (other.height_m <= plane.height_m + kHigher_m) continue;
      if (next == nullptr || other.height_m < next->height_m) next = &other;
    }
    if (next == nullptr) return;
    h.plan[kLowStep] = std::max(0.0, 1.0 - (next->height_m - plane.height_m) / kStorey_m);
    const double border_m = next->beyond_m + 0.25 * spacing_m_;
    h.plan[kUnderLowBorder] =
        h.plan[kLowStep] * std::max(0.0, 1.0 - std::abs(border_m) / kAtBorder_m);
  }

  void add_points(const Plane3& plane, bool is_lower, SurfaceHypothesis& h) const {
    const double share = standing_share(beside_, plane, kBeside_m, beside_.n_beside);
    h.plan[is_lower ? kStandLower : kStandBeside] = share;
    if (!is_lower) h.plan[kStandIn] = standing_share(beside_, plane, kIn_m, beside_.n_in);
  }

  std::span<const CandidatePlane> candidates_;
  const Footprint& footprint_;
  const JudgeOptions& options_;
  double spacing_m_;
  Stretches stretches_;
  PointsBeside beside_;
  std::vector<PlacedPlane> placed_;
};

}  // namespace

std::vector<SurfaceHypothesis> surface_hypotheses(std::span<const ZonePoint> zone,
                                                  std::span<const CandidatePlane> candidates,
                                                  const Footprint& footprint,
                                                  const Segment3& segment,
                                                  const std::optional<Eigen::Vector2d>& inside,
                                                  const JudgeOptions& options) {
  const Hypotheses hypotheses(zone, candidates, footprint, options);
  std::vector<SurfaceHypothesis> all{hypotheses.object(zone, segment)};
  if (!inside) std::ranges::move(hypotheses.meetings(), std::back_inserter(all));
  std::ranges::move(hypotheses.steps(inside), std::back_inserter(all));
  return all;
}

}  // namespace ridgeline::evaluate
