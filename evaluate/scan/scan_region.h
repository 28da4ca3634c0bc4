// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/alpha_shape.h"
#include "evaluate/scan/grow_planes.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A region in the frame of its plane: u level, v up the slope, both in the plane, origin at its
/// centroid. On a level plane, u is the direction of its largest spread.
struct ScanRegion {
  PlaneFit fit;
  std::vector<std::size_t> points;   ///< indices
  Eigen::Matrix<double, 3, 2> axes;  ///< u and v in the local frame
  std::vector<Eigen::Vector2d> uv;   ///< of `points`, m
  double spacing_m = 0.0;            ///< 1 / sqrt(points per area)
  bool is_upright = false;           ///< a wall
  AlphaShape shape;                  ///< of roofs only

  [[nodiscard]] double area_m2() const {
    return static_cast<double>(points.size()) * spacing_m * spacing_m;
  }
  [[nodiscard]] Eigen::Vector2d in_plane(const Eigen::Vector3d& x) const {
    return axes.transpose() * (x - fit.centroid);
  }
  [[nodiscard]] Eigen::Vector3d in_local(const Eigen::Vector2d& uv_m) const {
    return fit.centroid + axes * uv_m;
  }
};

ScanRegion make_scan_region(PlaneRegion region,
                            std::span<const Eigen::Vector3d> points,
                            const PointNeighbours& neighbours);

/// A side of the cells that a region covers, in its plane.
struct CellSide {
  Eigen::Vector2d middle_m, out;  ///< `out` is a unit vector
};

/// The border of a region by cells of a few spacings: coarse, but much faster than its alpha shape,
/// which for the ground of a cell of the map would take most of the time.
std::vector<CellSide> coarse_border(const ScanRegion& region);

}  // namespace ridgeline::evaluate
