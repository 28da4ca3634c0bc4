// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_grid.h"
#include "io/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>

namespace ridgeline::results {

/// Memory for a point as read, for its copy in the grid, and for its share of the cells while the
/// grid is built.
inline constexpr std::uint64_t kBytesPerPoint =
    sizeof(io::CloudPoint) + sizeof(evaluate::PointGrid::Point) + 32;

/// Builds a grid of the points of a cloud and releases them from the cloud.
inline evaluate::PointGrid grid_of(io::PointCloud& cloud) {
  const auto position = [&](std::size_t i) {
    const io::CloudPoint& p = cloud.points[i];
    return Eigen::Vector3d(p.x, p.y, p.z);
  };
  evaluate::PointGrid grid = evaluate::PointGrid::build(cloud.points.size(), position);
  cloud.points = {};
  return grid;
}

}  // namespace ridgeline::results
