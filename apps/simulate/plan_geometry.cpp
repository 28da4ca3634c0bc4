// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/plan_geometry.h"

#include <algorithm>

namespace ridgeline::simulate {
namespace {

bool separated_by_side_of(const ConvexPolygon& a, const ConvexPolygon& b) {
  for (const PlanFunction& side : half_planes(a)) {
    const bool all_outside =
        std::all_of(b.begin(), b.end(), [&](const auto& corner) { return side(corner) <= 0.0; });
    if (all_outside) return true;
  }
  return false;
}

}  // namespace

Plane3 plane_of(const PlanFunction& height) {
  const Eigen::Vector3d direction(-height.gradient.x(), -height.gradient.y(), 1.0);
  const double norm = direction.norm();
  return {Eigen::Vector3d(direction / norm), -height.offset / norm};
}

ConvexPolygon rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

std::vector<PlanFunction> half_planes(const ConvexPolygon& polygon) {
  std::vector<PlanFunction> sides;
  sides.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& start = polygon[i];
    const Eigen::Vector2d along = (polygon[(i + 1) % polygon.size()] - start).normalized();
    const Eigen::Vector2d inward(-along.y(), along.x());
    sides.push_back({inward, -inward.dot(start)});
  }
  return sides;
}

bool contains(const ConvexPolygon& polygon, const Eigen::Vector2d& x) {
  const std::vector<PlanFunction> sides = half_planes(polygon);
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return side(x) >= 0.0; });
}

bool overlap(const ConvexPolygon& a, const ConvexPolygon& b) {
  return !separated_by_side_of(a, b) && !separated_by_side_of(b, a);
}

double area(const ConvexPolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

LabelledPolygon clip(const LabelledPolygon& polygon, const PlanFunction& inside, int label) {
  LabelledPolygon result;
  const std::size_t n = polygon.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d& a = polygon.corners[i];
    const Eigen::Vector2d& b = polygon.corners[(i + 1) % n];
    const double fa = inside(a);
    const double fb = inside(b);
    if (fa >= 0.0) {
      result.corners.push_back(a);
      // a side that leaves the half-plane exactly at corner a is replaced by the new side
      result.labels.push_back(fa == 0.0 && fb < 0.0 ? label : polygon.labels[i]);
    }
    if ((fa > 0.0 && fb < 0.0) || (fa < 0.0 && fb > 0.0)) {
      result.corners.emplace_back(a + (b - a) * (fa / (fa - fb)));
      result.labels.push_back(fa > 0.0 ? label : polygon.labels[i]);
    }
  }
  constexpr double kEmptyAreaM2 = 1e-9;
  if (result.corners.size() < 3 || area(result.corners) < kEmptyAreaM2) return {};
  return result;
}

ConvexPolygon clip(const ConvexPolygon& polygon, std::span<const PlanFunction> inside) {
  LabelledPolygon result{polygon, std::vector<int>(polygon.size(), 0)};
  for (const PlanFunction& side : inside) result = clip(result, side, 0);
  return result.corners;
}

PlanInterval clip(PlanInterval interval, const Segment2& segment, const PlanFunction& inside) {
  const double f0 = inside(segment.start);
  const double slope = inside.gradient.dot(segment.end - segment.start);
  if (slope == 0.0) return f0 >= 0.0 ? interval : PlanInterval{0.0, 0.0};
  const double root = -f0 / slope;
  if (slope > 0.0) {
    interval.begin = std::max(interval.begin, root);
  } else {
    interval.end = std::min(interval.end, root);
  }
  return interval;
}

std::vector<PlanInterval> subtract(std::span<const PlanInterval> intervals,
                                   const PlanInterval& hole) {
  std::vector<PlanInterval> result;
  for (const PlanInterval& interval : intervals) {
    if (hole.empty() || hole.end <= interval.begin || hole.begin >= interval.end) {
      result.push_back(interval);
      continue;
    }
    if (hole.begin > interval.begin) result.push_back({interval.begin, hole.begin});
    if (hole.end < interval.end) result.push_back({hole.end, interval.end});
  }
  return result;
}

std::optional<Segment2> intersection(const PlanFunction& height_a,
                                     const ConvexPolygon& polygon_a,
                                     const PlanFunction& height_b,
                                     const ConvexPolygon& polygon_b) {
  constexpr double kParallel = 1e-9;  // difference of slopes
  constexpr double kReachM = 1e4;     // longer than any roof
  const PlanFunction difference = height_a - height_b;
  const double steepness = difference.gradient.norm();
  if (steepness < kParallel || polygon_a.empty() || polygon_b.empty()) return std::nullopt;
  const Eigen::Vector2d normal = difference.gradient / steepness;
  const Eigen::Vector2d along(-normal.y(), normal.x());
  const Eigen::Vector2d foot =
      polygon_a.front() - normal * (difference(polygon_a.front()) / steepness);
  const Segment2 line{foot - kReachM * along, foot + kReachM * along};
  PlanInterval interval;
  for (const ConvexPolygon* polygon : {&polygon_a, &polygon_b}) {
    for (const PlanFunction& side : half_planes(*polygon)) interval = clip(interval, line, side);
  }
  if (interval.empty()) return std::nullopt;
  const auto at = [&](double t) -> Eigen::Vector2d {
    return foot + ((2.0 * t - 1.0) * kReachM) * along;
  };
  return Segment2{at(interval.begin), at(interval.end)};
}

}  // namespace ridgeline::simulate
