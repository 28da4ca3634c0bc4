// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The area that points of the plane cover: the triangles of their Delaunay triangulation whose
/// circumcircle is not larger than random points of the same density leave empty (alpha shape,
/// Edelsbrunner 1983).
struct AlphaShape {
  double area_m2 = 0.0;
  /// The border: closed chains of indices of points; the area lies to their left. The outer border
  /// runs counter-clockwise, holes clockwise.
  std::vector<std::vector<std::size_t>> loops;
};

/// Coordinates are rounded to 0.1 mm for the triangulation. Empty for collinear points.
AlphaShape alpha_shape(std::span<const Eigen::Vector2d> points_m);

}  // namespace ridgeline::evaluate
