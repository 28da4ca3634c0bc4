// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/rims.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kMinRim_m = 0.2, kMaxRim_m = 1.5;
constexpr double kRimReach_m = 1.2;  ///< how far outside of the border its points may lie
constexpr std::size_t kMinRimPoints = 5;
constexpr double kMinRimLength_m = 3.0;  ///< a branch over a border has no length

struct RimPoint {
  Eigen::Vector2d st;
  double above_m;
};

/// Points above the plane next to the border that are on no other plane; empty if half as many lie
/// higher or on planes: a wall, a tree, the next roof.
std::vector<RimPoint> points_above(const ScanRegion& region,
                                   const Segment2& border,
                                   const BorderSurroundings& surroundings) {
  std::vector<RimPoint> points;
  std::size_t n_higher = 0;
  surroundings.visit_outside(region, border, kRimReach_m,
                             [&](const Eigen::Vector2d& st, double above_m, bool in_region) {
                               if (st.y() < -kMinRim_m || above_m < kMinRim_m) return;
                               if (above_m > kMaxRim_m || in_region) {
                                 ++n_higher;
                               } else {
                                 points.push_back({st, above_m});
                               }
                             });
  if (2 * n_higher > points.size()) points.clear();
  return points;
}

}  // namespace

std::optional<Rim> find_rim(const ScanRegion& region,
                            const Border& border,
                            const BorderSurroundings& surroundings) {
  constexpr double kMinShare = 0.6, kMinSupport = 0.7, kRimReachSpacings = 2.0, kDeviations = 3.5;
  const double length_m = length(border.uv_m), sigma_m = region.fit.sigma0_m;
  if (length_m < kMinRimLength_m) return std::nullopt;
  std::vector<RimPoint> points = points_above(region, border.uv_m, surroundings);
  if (points.size() < kMinRimPoints) return std::nullopt;
  Rim rim;
  rim.height_m = upper_median(transformed(points, &RimPoint::above_m));
  const auto n_all = static_cast<double>(points.size());
  const double tolerance_m = std::max(kDeviations * sigma_m, 0.1);
  std::erase_if(
      points, [&](const RimPoint& p) { return std::abs(p.above_m - rim.height_m) > tolerance_m; });
  const auto n = static_cast<double>(points.size());
  if (points.size() < kMinRimPoints || n < kMinShare * n_all) return std::nullopt;
  const std::vector<Eigen::Vector2d> st = transformed(points, &RimPoint::st);
  if (supported_share(st, length_m, kRimReachSpacings * region.spacing_m) < kMinSupport)
    return std::nullopt;
  rim.sigma_height_m = sigma_m / std::sqrt(n);
  constexpr double kParallel_deg = 0.5;
  rim.outer_line =
      border_line({.st_m = st,
                   .length_m = length_m,
                   .sigma_m = sigma_m,
                   .usual_slope = 0.0,
                   .usual_slope_sigma = std::hypot(kParallel_deg * kRadPerDeg,
                                                   std::sqrt(border.line.covariance(1, 1)))});
  const Eigen::Vector2d u = along(border.uv_m), out(u.y(), -u.x());
  const double half_m = 0.5 * length_m * rim.outer_line.slope;
  rim.outer_uv_m = {border.uv_m.start + (rim.outer_line.offset_m - half_m) * out,
                    border.uv_m.end + (rim.outer_line.offset_m + half_m) * out};
  return rim;
}

}  // namespace ridgeline::evaluate
