// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plan_hull.h"

#include "reconstruct/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::evaluate {
namespace {

/// Twice the signed area of the triangle, positive if it turns left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// One side of Andrew's monotone chain: the left-turning corners of sorted points, without the last
/// one, which begins the other side.
template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<Eigen::Vector2d>& corners) {
  const std::size_t base = corners.size();
  for (auto it = first; it != last; ++it) {
    while (corners.size() >= base + 2 &&
           turn(corners[corners.size() - 2], corners.back(), *it) <= 0.0) {
      corners.pop_back();
    }
    corners.push_back(*it);
  }
  corners.pop_back();
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::vector<Eigen::Vector2d> corners;
  if (points.empty()) return corners;
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  add_chain(points.begin(), points.end(), corners);
  add_chain(points.rbegin(), points.rend(), corners);
  if (corners.empty() || points.front() == points.back()) return {points.front()};
  return corners;
}

PlanHull::PlanHull(std::span<const ZonePoint> points) {
  std::vector<Eigen::Vector2d> st;
  st.reserve(points.size());
  for (const ZonePoint& p : points) st.emplace_back(p.s, p.t);
  corners_ = convex_hull(std::move(st));
}

bool PlanHull::contains(const Eigen::Vector2d& st) const {
  if (corners_.size() < 3) return false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (turn(corners_[i], corners_[(i + 1) % corners_.size()], st) < 0.0) return false;
  }
  return true;
}

double PlanHull::distance_to(const Eigen::Vector2d& st) const {
  if (contains(st)) return 0.0;
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    nearest =
        std::min(nearest, distance(Segment2{corners_[i], corners_[(i + 1) % corners_.size()]}, st));
  }
  return nearest;
}

}  // namespace ridgeline::evaluate
