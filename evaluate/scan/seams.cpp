// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/seams.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ridgeline::evaluate {
namespace {

constexpr double kMinSeamAngle_deg = 6.0;
constexpr double kMinSeam_m = 0.8;
/// In spacings of the points: how far a point may lie from the intersection, and how much of it to
/// both sides it supports.
constexpr double kSeamReach = 1.5, kSeamSupport = 1.5;

struct Interval1 {
  double low, high;
};

struct InfiniteLine {
  Eigen::Vector3d x, direction;
};

std::optional<InfiniteLine> intersection_of(const ScanRegion& a, const ScanRegion& b) {
  const Eigen::Vector3d na = a.fit.plane.normal(), nb = b.fit.plane.normal();
  const Eigen::Vector3d across = na.cross(nb);
  if (across.norm() < std::sin(kMinSeamAngle_deg * kRadPerDeg)) return std::nullopt;
  // the point of the line next to the middle of the two regions
  const Eigen::Vector3d middle = 0.5 * (a.fit.centroid + b.fit.centroid);
  Eigen::Matrix3d m;
  m << na.transpose(), nb.transpose(), across.transpose();
  const Eigen::Vector3d by(-a.fit.plane.signedDistance(middle), -b.fit.plane.signedDistance(middle),
                           0.0);
  return InfiniteLine{middle + m.fullPivLu().solve(by), across.normalized()};
}

/// The parts of a line that have points of a region next to them, ascending.
std::vector<Interval1> covered(const ScanRegion& region,
                               const InfiniteLine& line,
                               double reach_m,
                               double support_m) {
  const Eigen::Vector2d foot = region.in_plane(line.x);
  const Eigen::Vector2d along = (region.axes.transpose() * line.direction).normalized();
  std::vector<double> s;
  for (const Eigen::Vector2d& uv : region.uv) {
    const Eigen::Vector2d d = uv - foot;
    if (std::abs(along.x() * d.y() - along.y() * d.x()) <= reach_m) s.push_back(along.dot(d));
  }
  std::ranges::sort(s);
  std::vector<Interval1> parts;
  for (const double x : s) {
    if (!parts.empty() && x - support_m <= parts.back().high) {
      parts.back().high = x + support_m;
    } else {
      parts.push_back({x - support_m, x + support_m});
    }
  }
  return parts;
}

std::vector<Interval1> common(std::span<const Interval1> a, std::span<const Interval1> b) {
  std::vector<Interval1> both;
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const Interval1 part{std::max(a[i].low, b[j].low), std::min(a[i].high, b[j].high)};
    if (part.low < part.high) both.push_back(part);
    (a[i].high < b[j].high ? i : j) += 1;
  }
  return both;
}

/// How far, on average, the points of a region next to a part of a line lie above another plane.
double height_above_m(const ScanRegion& region,
                      const Plane3& plane,
                      const InfiniteLine& line,
                      const Interval1& part) {
  constexpr double kReach = 4.0;  // spacings
  double sum_m = 0.0;
  int n = 0;
  for (const Eigen::Vector2d& uv : region.uv) {
    const Eigen::Vector3d x = region.in_local(uv);
    const double s = line.direction.dot(x - line.x);
    if (s < part.low || s > part.high ||
        (x - line.x - s * line.direction).norm() > kReach * region.spacing_m)
      continue;
    sum_m += plane.signedDistance(x);
    ++n;
  }
  return n == 0 ? 0.0 : sum_m / n;
}

void add_seams(std::span<const ScanRegion> regions,
               std::size_t a,
               std::size_t b,
               std::vector<Seam>& seams) {
  const auto line = intersection_of(regions[a], regions[b]);
  if (!line) return;
  const double spacing_m = std::max(regions[a].spacing_m, regions[b].spacing_m);
  const double reach_m = kSeamReach * spacing_m, support_m = kSeamSupport * spacing_m;
  const std::vector<Interval1> on_a = covered(regions[a], *line, reach_m, support_m);
  const std::vector<Interval1> on_b = covered(regions[b], *line, reach_m, support_m);
  for (const Interval1& part : common(on_a, on_b)) {
    // the mean gap beyond the outermost point is 1 / (density x width)
    const double beyond_m = spacing_m / (2.0 * kSeamReach);
    const double low = part.low + support_m - beyond_m, high = part.high - support_m + beyond_m;
    if (high - low < kMinSeam_m) continue;
    const double above_m = height_above_m(regions[a], regions[b].fit.plane, *line, part) +
                           height_above_m(regions[b], regions[a].fit.plane, *line, part);
    seams.push_back({.regions = {a, b},
                     .segment = {line->x + low * line->direction, line->x + high * line->direction},
                     .support = 1.0,
                     .is_valley = above_m > 0.0});
  }
}

}  // namespace

std::vector<Seam> find_seams(std::span<const ScanRegion> regions,
                             std::span<const std::pair<std::size_t, std::size_t>> pairs) {
  std::vector<Seam> seams;
  for (const auto& [a, b] : pairs) {
    if (regions[a].is_upright || regions[b].is_upright) continue;
    add_seams(regions, a, b, seams);
  }
  return seams;
}

}  // namespace ridgeline::evaluate
