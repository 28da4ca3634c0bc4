// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace ridgeline {
namespace {

template <typename Segment, typename Vector>
double clamped_parameter(const Segment& segment, const Vector& x) {
  const Vector direction = segment.end - segment.start;
  const double squared_length = direction.squaredNorm();
  if (squared_length <= 0.0) return 0.0;
  return std::clamp(direction.dot(x - segment.start) / squared_length, 0.0, 1.0);
}

template <typename Segment, typename Vector>
double clamped_distance(const Segment& segment, const Vector& x) {
  const double t = clamped_parameter(segment, x);
  return ((1.0 - t) * segment.start + t * segment.end - x).norm();
}

/// Twice the signed area of the triangle abc: positive if c is to the left of a->b.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether the segments cross at a point inside both.
bool cross_properly(const Segment2& a, const Segment2& b) {
  return turn(a.start, a.end, b.start) * turn(a.start, a.end, b.end) < 0.0 &&
         turn(b.start, b.end, a.start) * turn(b.start, b.end, a.end) < 0.0;
}

}  // namespace

double closest_parameter(const Segment2& segment, const Eigen::Vector2d& x) {
  return clamped_parameter(segment, x);
}
double closest_parameter(const Segment3& segment, const Eigen::Vector3d& x) {
  return clamped_parameter(segment, x);
}
double distance(const Segment2& segment, const Eigen::Vector2d& x) {
  return clamped_distance(segment, x);
}
double distance(const Segment3& segment, const Eigen::Vector3d& x) {
  return clamped_distance(segment, x);
}

double distance(const Segment2& a, const Segment2& b) {
  if (cross_properly(a, b)) return 0.0;
  return std::min(
      {distance(a, b.start), distance(a, b.end), distance(b, a.start), distance(b, a.end)});
}

double acute_angle_rad(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), std::abs(a.dot(b)));
}
double acute_angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

double acute_angle_rad(const Segment2& a, const Segment2& b) {
  return acute_angle_rad(Eigen::Vector2d(a.end - a.start), Eigen::Vector2d(b.end - b.start));
}

std::optional<Eigen::Vector2d> intersection(const Segment2& a,
                                            const Segment2& b,
                                            double min_angle_rad) {
  const Eigen::Vector2d u = a.end - a.start;
  const Eigen::Vector2d v = b.end - b.start;
  if (acute_angle_rad(u, v) <= min_angle_rad) return std::nullopt;
  const Eigen::Vector2d w = b.start - a.start;
  const double t = (w.x() * v.y() - w.y() * v.x()) / (u.x() * v.y() - u.y() * v.x());
  return a.start + t * u;
}

bool are_fragments(const Segment2& a, const Segment2& b, double tolerance_px) {
  const std::array<Eigen::Vector2d, 4> ends{a.start, a.end, b.start, b.end};
  Segment2 whole = a;
  for (const Eigen::Vector2d& from : ends) {
    for (const Eigen::Vector2d& to : ends) {
      if ((to - from).squaredNorm() > (whole.end - whole.start).squaredNorm()) whole = {from, to};
    }
  }
  const Eigen::Vector2d along = (whole.end - whole.start).normalized();
  return std::all_of(ends.begin(), ends.end(), [&](const Eigen::Vector2d& x) {
    const Eigen::Vector2d w = x - whole.start;
    return std::abs(along.x() * w.y() - along.y() * w.x()) <= tolerance_px;
  });
}

}  // namespace ridgeline
