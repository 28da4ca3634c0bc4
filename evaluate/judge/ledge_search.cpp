// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ledge_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kReach_m = 0.75;     // from the line to the strip's points, in plan
constexpr double kMinHeight_m = 0.2;  // above the neighbouring surface
constexpr double kMaxHeight_m = 1.5;
constexpr int kMinLedgePoints = 8;      // a parapet of 0.3 m x 6 m at 5 points/m2
constexpr double kMaxLedgeSlope = 0.2;  // slope along the line
constexpr double kMaxWidth_m = 0.8;     // across; a bonnet is wider

/// Heights along the line: z = height + slope s.
struct Profile {
  double height, slope;
  [[nodiscard]] double residual(const ZonePoint& p) const { return p.x.z() - height - slope * p.s; }
};

std::vector<ZonePoint> unexplained_above(std::span<const ZonePoint> zone,
                                         std::span<const CandidatePlane> candidates,
                                         const Footprint& footprint) {
  std::vector<ZonePoint> points;
  for (const ZonePoint& p : zone) {
    if (std::abs(p.t) > kReach_m || p.s < 0.0 || p.s > footprint.length_m) continue;
    double above_m = HUGE_VAL;  // height above the highest surface at the point
    for (const CandidatePlane& plane : candidates) {
      above_m = std::min(above_m, p.x.z() - height_at(plane.fit.plane, p.x.head<2>()));
    }
    if (above_m >= kMinHeight_m && above_m <= kMaxHeight_m) points.push_back(p);
  }
  return points;
}

std::vector<ZonePoint> on_profile(const std::vector<ZonePoint>& points,
                                  const Profile& profile,
                                  double distance_m) {
  std::vector<ZonePoint> near;
  for (const ZonePoint& p : points) {
    if (std::abs(profile.residual(p)) <= distance_m) near.push_back(p);
  }
  return near;
}

/// The points near a profile through two points, for the profile with the most points near it. At
/// most some thousand pairs are tried, in a fixed order, so that the result depends only on the
/// points.
std::vector<ZonePoint> best_profile(const std::vector<ZonePoint>& points, double distance_m) {
  constexpr std::size_t kMaxPairs = 2000;
  const std::size_t n = points.size();
  const std::size_t stride = 1 + n * (n - 1) / 2 / kMaxPairs;
  std::vector<ZonePoint> best;
  std::size_t pair = 0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const double along = points[b].s - points[a].s;
      if (pair++ % stride != 0 || std::abs(along) < 1.0) continue;
      const double slope = (points[b].x.z() - points[a].x.z()) / along;
      if (std::abs(slope) > kMaxLedgeSlope) continue;
      const Profile profile{points[a].x.z() - slope * points[a].s, slope};
      std::vector<ZonePoint> near = on_profile(points, profile, distance_m);
      if (near.size() > best.size()) best = std::move(near);
    }
  }
  return best;
}

/// Extent across the line of all points of the corridor in the plane; a wide surface is not a
/// ledge. The ends of the line are left out, since another parapet may adjoin there from the side.
double width_in(std::span<const ZonePoint> zone,
                const PlaneFit& fit,
                const JudgeOptions& options,
                double length_m) {
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  for (const ZonePoint& p : zone) {
    if (std::abs(p.t) > options.corridor_half_width_m || p.s < kMaxWidth_m ||
        p.s > length_m - kMaxWidth_m || fit.plane.absDistance(p.x) > options.inlier_distance_m) {
      continue;
    }
    lowest = std::min(lowest, p.t);
    highest = std::max(highest, p.t);
  }
  return highest - lowest;
}

/// Least squares fit of the heights along s, as a plane that is level across the line.
PlaneFit level_across(const std::vector<ZonePoint>& points, const Footprint& footprint) {
  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double s_mean = 0.0;
  for (const ZonePoint& p : points) {
    centroid += p.x / n;
    s_mean += p.s / n;
  }
  double ss = 0.0;
  double sz = 0.0;
  for (const ZonePoint& p : points) {
    ss += (p.s - s_mean) * (p.s - s_mean);
    sz += (p.s - s_mean) * (p.x.z() - centroid.z());
  }
  const double slope = sz / ss;
  const Eigen::Vector3d along =
      Eigen::Vector3d(footprint.along.x(), footprint.along.y(), slope).normalized();
  const Eigen::Vector3d across(footprint.across.x(), footprint.across.y(), 0.0);
  PlaneFit fit;
  fit.plane = upward(Plane3(Eigen::Vector3d(along.cross(across).normalized()), centroid));
  fit.centroid = centroid;
  fit.axes << along, across;
  fit.spread_m2 << ss, HUGE_VAL;  // level across by assumption: no uncertainty in that direction
  fit.n = static_cast<int>(points.size());
  double squares = 0.0;
  for (const ZonePoint& p : points) {
    squares += std::pow(fit.plane.signedDistance(p.x), 2);
  }
  fit.rms_m = std::sqrt(squares / n);
  fit.sigma0_m = std::sqrt(squares / (n - 2.0));
  return fit;
}

}  // namespace

std::optional<CandidatePlane> search_ledge(std::span<const ZonePoint> zone,
                                           std::span<const CandidatePlane> candidates,
                                           const Footprint& footprint,
                                           const JudgeOptions& options) {
  constexpr std::size_t kMaxPoints = 400;  // points of a strip; more are a hedge or a canopy
  if (candidates.empty()) return std::nullopt;
  const std::vector<ZonePoint> points = unexplained_above(zone, candidates, footprint);
  if (points.size() < kMinLedgePoints || points.size() > kMaxPoints) return std::nullopt;
  const std::vector<ZonePoint> strip = best_profile(points, options.inlier_distance_m);
  // a hedge scatters in height: at least half of the points above the surface must belong to the
  // ledge
  if (strip.size() < kMinLedgePoints || 2 * strip.size() < points.size()) return std::nullopt;
  const PlaneFit fit = level_across(strip, footprint);
  if (width_in(zone, fit, options, footprint.length_m) > kMaxWidth_m) return std::nullopt;
  return CandidatePlane{.fit = fit, .inliers = strip, .beside = {}};
}

}  // namespace ridgeline::evaluate
