// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_meeting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Gradient (dz/dx, dz/dy) of a plane that is not vertical.
Eigen::Vector2d gradient(const Plane3& plane) {
  return -plane.normal().head<2>() / plane.normal().z();
}

/// The straight line in plan where two planes have equal heights: normal'x = offset, |normal| = 1,
/// the first plane above the second on the side of the normal.
struct PlanIntersection {
  Eigen::Vector2d normal;
  double offset;
  [[nodiscard]] double distance(const Eigen::Vector2d& x) const { return normal.dot(x) - offset; }
};

std::optional<PlanIntersection> intersect_in_plan(const Plane3& a, const Plane3& b) {
  constexpr double kParallel = 1e-6;  // gradients that differ by 1 mm per kilometre
  const Eigen::Vector2d difference = gradient(a) - gradient(b);
  const double steepness = difference.norm();
  if (!(steepness > kParallel)) return std::nullopt;
  const double at_zero =
      height_at(a, Eigen::Vector2d::Zero()) - height_at(b, Eigen::Vector2d::Zero());
  return PlanIntersection{difference / steepness, -at_zero / steepness};
}

struct SideShare {
  double positive;              ///< share of the points on the positive side
  std::vector<ZonePoint> near;  ///< points close to the intersection
};

SideShare sides_of(const CandidatePlane& plane,
                   const PlanIntersection& line,
                   double length_m,
                   double near_m) {
  // points this close to the intersection provide no evidence of the side: they lie in both planes
  constexpr double kOnLine_m = 0.2;
  std::size_t positive = 0;
  std::size_t counted = 0;
  SideShare share{0.0, {}};
  for (const ZonePoint& p : plane.beside) {
    const double d = line.distance(p.x.head<2>());
    if (std::abs(d) > near_m || p.s < 0.0 || p.s > length_m) continue;
    share.near.push_back(p);
    if (std::abs(d) < kOnLine_m) continue;
    ++counted;
    positive += d > 0.0 ? 1 : 0;
  }
  if (counted > 0) share.positive = static_cast<double>(positive) / static_cast<double>(counted);
  return share;
}

/// Fits the plane to those of its points that lie on one side of the intersection.
void keep_side(CandidatePlane& plane,
               const std::vector<ZonePoint>& points,
               const PlanIntersection& line,
               double side) {
  std::vector<ZonePoint> kept;
  std::vector<Eigen::Vector3d> x;
  for (const ZonePoint& p : points) {
    if (side * line.distance(p.x.head<2>()) < 0.0) continue;
    kept.push_back(p);
    x.push_back(p.x);
  }
  const std::optional<PlaneFit> fit = fit_plane(x);
  if (!fit) return;
  plane.fit = *fit;
  plane.inliers = std::move(kept);
}

}  // namespace

double angle_between_rad(const PlaneFit& a, const PlaneFit& b) {
  return acute_angle_rad(Eigen::Vector3d(a.plane.normal()), Eigen::Vector3d(b.plane.normal()));
}

std::optional<PlaneMeeting> meeting_of(const CandidatePlane& a,
                                       const CandidatePlane& b,
                                       const Footprint& footprint,
                                       const JudgeOptions& options) {
  // minimum difference between the planes' shares of points on one side; less than 1, because a
  // main roof continues behind a dormer
  constexpr double kOneSided = 0.55;
  const auto line = intersect_in_plan(a.fit.plane, b.fit.plane);
  if (!line) return std::nullopt;
  const SideShare side_a =
      sides_of(a, *line, footprint.length_m, options.corridor_half_width_m * 2.0 / 3.0);
  const SideShare side_b =
      sides_of(b, *line, footprint.length_m, options.corridor_half_width_m * 2.0 / 3.0);
  if (std::abs(side_a.positive - side_b.positive) < kOneSided) return std::nullopt;
  const double reach_m = 0.5 * options.corridor_half_width_m;
  const Eigen::Vector2d direction(-line->normal.y(), line->normal.x());
  return PlaneMeeting{
      .offset_m = std::max(std::abs(line->distance(footprint.start)),
                           std::abs(line->distance(footprint.at(footprint.length_m)))),
      .direction_rad = acute_angle_rad(direction, footprint.along),
      .coverage = std::min(coverage_along(side_a.near, footprint.length_m, reach_m),
                           coverage_along(side_b.near, footprint.length_m, reach_m))};
}

void separate_at_intersection(CandidatePlane& a, CandidatePlane& b) {
  constexpr int kPasses = 3;  // the intersection moves less in each pass
  const std::vector<ZonePoint> all_a = a.inliers;
  const std::vector<ZonePoint> all_b = b.inliers;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto line = intersect_in_plan(a.fit.plane, b.fit.plane);
    if (!line) return;
    const double side = line->distance(a.fit.centroid.head<2>()) > 0.0 ? 1.0 : -1.0;
    keep_side(a, all_a, *line, side);
    keep_side(b, all_b, *line, -side);
  }
}

}  // namespace ridgeline::evaluate
