// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>

namespace ridgeline {

/// An image line segment in pixels; pixel (0,0) is the centre of the top-left pixel.
struct Segment2 {
  Eigen::Vector2d start, end;
};

/// An object-space line segment in metres.
struct Segment3 {
  Eigen::Vector3d start, end;
};

inline double length(const Segment2& s) { return (s.end - s.start).norm(); }
inline double length(const Segment3& s) { return (s.end - s.start).norm(); }
inline Eigen::Vector2d midpoint(const Segment2& s) { return 0.5 * (s.start + s.end); }
inline Eigen::Vector3d midpoint(const Segment3& s) { return 0.5 * (s.start + s.end); }
inline Eigen::Vector3d point_at(const Segment3& s, double t) {
  return (1.0 - t) * s.start + t * s.end;
}
inline Eigen::Vector2d point_at(const Segment2& s, double t) {
  return (1.0 - t) * s.start + t * s.end;
}
/// Unit vector u from start to end.
inline Eigen::Vector2d along(const Segment2& s) { return (s.end - s.start).normalized(); }
/// n = (-u_y, u_x) points to the right of the segment, because y runs down in an image.
inline Eigen::Vector2d normal_of(const Eigen::Vector2d& u) { return {-u.y(), u.x()}; }
inline Eigen::Vector2d normal(const Segment2& s) { return normal_of(along(s)); }
/// Parameter of the foot of `x` on the infinite line of the segment, 0 at its start and 1 at its
/// end.
inline double parameter_along(const Segment2& s, const Eigen::Vector2d& x) {
  const Eigen::Vector2d d = s.end - s.start;
  return d.dot(x - s.start) / d.squaredNorm();
}
inline double parameter_along(const Segment3& s, const Eigen::Vector3d& x) {
  const Eigen::Vector3d d = s.end - s.start;
  return d.dot(x - s.start) / d.squaredNorm();
}
inline bool all_finite(const Segment3& s) { return s.start.allFinite() && s.end.allFinite(); }

/// The plan view (x, y) of a segment.
inline Segment2 plan(const Segment3& s) { return {s.start.head<2>(), s.end.head<2>()}; }

/// Parameter t in [0, 1] of the point of the segment closest to `x`; 0 for a segment of zero
/// length.
double closest_parameter(const Segment2& segment, const Eigen::Vector2d& x);
double closest_parameter(const Segment3& segment, const Eigen::Vector3d& x);

/// Distance from `x` to the segment itself, not to its infinite line.
double distance(const Segment2& segment, const Eigen::Vector2d& x);
double distance(const Segment3& segment, const Eigen::Vector3d& x);

/// Smallest distance between the segments; 0 if they cross or touch.
double distance(const Segment2& a, const Segment2& b);

/// Acute angle in [0, pi/2] between two directions of any length, computed by atan2(|a x b|,
/// |a.b|), which, unlike acos, stays accurate near 0 and pi/2. The angle is 0 if either has zero
/// length.
double acute_angle_rad(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
double acute_angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
double acute_angle_rad(const Segment2& a, const Segment2& b);

/// The point where the infinite lines of two segments meet; std::nullopt if their acute angle is at
/// most `min_angle_rad`.
std::optional<Eigen::Vector2d> intersection(const Segment2& a,
                                            const Segment2& b,
                                            double min_angle_rad);

/// Whether two segments of an image are parts of one straight edge: all their ends lie within the
/// tolerance of the line through the two ends that are farthest apart.
bool are_fragments(const Segment2& a, const Segment2& b, double tolerance_px = 1.5);

}  // namespace ridgeline
