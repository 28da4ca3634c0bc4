// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline {

/// The bounding box of points in plan; empty without points.
inline Eigen::AlignedBox2d box_around(std::span<const Eigen::Vector2d> points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& x : points) box.extend(x);
  return box;
}

/// The corners of a box, counter-clockwise.
inline std::vector<Eigen::Vector2d> corners_of(const Eigen::AlignedBox2d& box) {
  return {box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
}

/// The box grown by `margin` on all sides.
inline Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double margin) {
  const Eigen::Vector2d by = Eigen::Vector2d::Constant(margin);
  return {box.min() - by, box.max() + by};
}

/// Distance of a point to the left of side `i` of a polygon, multiplied by the length of the side.
inline double left_of_side(std::span<const Eigen::Vector2d> polygon,
                           std::size_t i,
                           const Eigen::Vector2d& x) {
  const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
  const Eigen::Vector2d way = x - polygon[i];
  return side.x() * way.y() - side.y() * way.x();
}

/// Whether a point lies in a convex polygon whose corners run counter-clockwise, or on its border.
/// Every point lies in a polygon without corners.
inline bool is_within(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& x) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (left_of_side(polygon, i, x) < 0.0) return false;
  }
  return true;
}

/// Whether a box and such a polygon share more than a border. The test is approximate: it may also
/// be true for a box next to a sharp corner.
inline bool meets(std::span<const Eigen::Vector2d> polygon, const Eigen::AlignedBox2d& box) {
  const std::vector<Eigen::Vector2d> corners = corners_of(box);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const bool all_outside = std::ranges::all_of(
        corners, [&](const Eigen::Vector2d& x) { return left_of_side(polygon, i, x) <= 0.0; });
    if (all_outside) return false;
  }
  return true;
}

}  // namespace ridgeline
