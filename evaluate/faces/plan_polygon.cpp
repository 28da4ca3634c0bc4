// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/plan_polygon.h"

#include <cmath>

namespace ridgeline::evaluate {
namespace {

/// Area and first moment of a ring about `origin`; the area is not negative.
struct Moments {
  double area_m2 = 0.0;
  Eigen::Vector2d first_m3 = Eigen::Vector2d::Zero();
};

Moments moments_of(const std::vector<Eigen::Vector3d>& ring, const Eigen::Vector2d& origin) {
  Moments sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i].head<2>() - origin;
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()].head<2>() - origin;
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    sum.area_m2 += area;
    sum.first_m3 += area / 3.0 * (a + b);
  }
  if (sum.area_m2 < 0.0) sum = {-sum.area_m2, -sum.first_m3};
  return sum;
}

}  // namespace

PlanPolygon::PlanPolygon(const std::vector<std::vector<Eigen::Vector3d>>& rings) {
  for (const std::vector<Eigen::Vector3d>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment2 edge{ring[i].head<2>(), ring[(i + 1) % ring.size()].head<2>()};
      box_.extend(edge.start);
      if (edge.start != edge.end) edges_.push_back(edge);
    }
  }
  set_area(rings);
}

void PlanPolygon::set_area(const std::vector<std::vector<Eigen::Vector3d>>& rings) {
  if (box_.isEmpty()) return;
  centroid_ = box_.center();
  Moments sum;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Moments ring = moments_of(rings[i], box_.center());
    const double sign = i == 0 ? 1.0 : -1.0;
    sum.area_m2 += sign * ring.area_m2;
    sum.first_m3 += sign * ring.first_m3;
  }
  area_m2_ = std::max(0.0, sum.area_m2);
  if (area_m2_ > 0.0) centroid_ += sum.first_m3 / area_m2_;
}

bool PlanPolygon::contains(const Eigen::Vector2d& x) const {
  if (!box_.contains(x)) return false;
  bool inside = false;
  for (const Segment2& edge : edges_) {
    const Eigen::Vector2d& a = edge.start;
    const Eigen::Vector2d& b = edge.end;
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    if (x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

PlanPolygon::Nearest PlanPolygon::nearest(const Eigen::Vector2d& x) const {
  Nearest nearest{0, HUGE_VAL, false};
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const double parameter = closest_parameter(edges_[i], x);
    const double distance = (x - point_at(edges_[i], parameter)).norm();
    if (distance < nearest.distance_m) {
      nearest = {i, distance, parameter > 0.0 && parameter < 1.0};
    }
  }
  return nearest;
}

double PlanPolygon::distance_m(const Eigen::Vector2d& x) const {
  return contains(x) ? 0.0 : nearest(x).distance_m;
}

}  // namespace ridgeline::evaluate
