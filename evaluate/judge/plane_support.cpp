// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_support.h"

#include "evaluate/judge/plan_hull.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ridgeline::evaluate {
namespace {

double median_distance(std::span<const ZonePoint> points, const Plane3& plane) {
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const ZonePoint& p : points) distances.push_back(plane.absDistance(p.x));
  return upper_median(std::move(distances));
}

}  // namespace

std::vector<Eigen::Vector3d> positions(std::span<const ZonePoint> points) {
  return transformed(points, &ZonePoint::x);
}

double point_spacing_m(std::size_t n, double area_m2) {
  return n == 0 ? HUGE_VAL : std::sqrt(area_m2 / static_cast<double>(n));
}

double coverage_along(std::span<const ZonePoint> points, double length_m, double reach_m) {
  std::vector<double> s;
  s.reserve(points.size());
  for (const ZonePoint& p : points) s.push_back(p.s);
  std::sort(s.begin(), s.end());
  double covered = 0.0;
  double end = 0.0;  // end of the part covered so far
  for (const double centre : s) {
    const double from = std::clamp(centre - reach_m, end, length_m);
    const double to = std::clamp(centre + reach_m, end, length_m);
    covered += to - from;
    end = std::max(end, to);
  }
  return covered / length_m;
}

double extrapolation_beyond(std::span<const ZonePoint> points, const Footprint& footprint) {
  // the distance to a convex set is convex along the line, so it is largest at one of its ends
  const PlanHull hull(points);
  return std::max(hull.distance_to({0.0, 0.0}), hull.distance_to({footprint.length_m, 0.0}));
}

void trim(CandidatePlane& plane, double inlier_distance_m) {
  constexpr int kMaxPasses = 20;
  constexpr double kMinDistance_m = 1e-6;       // below the resolution of any cloud
  constexpr double kThreeSigma = 3.0 * 1.4826;  // factor on the median of absolute normal residuals
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const double limit_m = std::clamp(kThreeSigma * median_distance(plane.inliers, plane.fit.plane),
                                      kMinDistance_m, inlier_distance_m);
    std::vector<ZonePoint> kept;
    for (const ZonePoint& p : plane.inliers) {
      if (plane.fit.plane.absDistance(p.x) <= limit_m) kept.push_back(p);
    }
    if (kept.size() == plane.inliers.size()) return;
    const std::optional<PlaneFit> fit = fit_plane(positions(kept));
    if (!fit) return;
    plane.fit = *fit;
    plane.inliers = std::move(kept);
  }
}

void describe_support(CandidatePlane& plane,
                      const Footprint& footprint,
                      double reach_m,
                      const JudgeOptions& options) {
  for (const ZonePoint& p : plane.inliers) {
    if (std::abs(p.t) <= options.corridor_half_width_m && p.s >= -options.corridor_end_m &&
        p.s <= footprint.length_m + options.corridor_end_m) {
      plane.beside.push_back(p);
    }
  }
  plane.coverage = coverage_along(plane.beside, footprint.length_m, reach_m);
}

std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   std::span<const std::size_t> chosen,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options) {
  // a plane must be known as accurately as from this many laser points on the line; three define a
  // plane
  constexpr double kMinPoints = 3.0;
  const double known_to_m = options.lidar_sigma_m / std::sqrt(kMinPoints);
  const Eigen::Vector2d middle = footprint.middle();
  for (const std::size_t i : chosen) {
    const PlaneFit& fit = candidates[i].fit;
    const double sigma_m = fit.sigma_at({middle.x(), middle.y(), height_at(fit.plane, middle)});
    if (sigma_m <= known_to_m) continue;
    return fmt::format("the sigma of its plane at the line is {:.3g} m, must be at most {:.3g} m",
                       sigma_m, known_to_m);
  }
  return std::nullopt;
}

}  // namespace ridgeline::evaluate
