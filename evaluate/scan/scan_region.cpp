// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/scan_region.h"

#include "reconstruct/geometry/faces/roof_edge.h"
#include "reconstruct/geometry/median.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ridgeline::evaluate {

namespace {

/// From the distances to the last of the neighbours, whose square times pi and the density has the
/// distribution of Gamma(k) with k points besides the first, if the points are random.
double spacing_m_of(std::span<const std::size_t> of_region,
                    std::span<const Eigen::Vector3d> points,
                    const PointNeighbours& neighbours) {
  const double median_of_gamma = static_cast<double>(neighbours.per_point()) - 1.0 - 1.0 / 3.0;
  std::vector<double> squares;
  squares.reserve(of_region.size());
  for (const std::size_t i : of_region)
    squares.push_back((points[neighbours.of(i).back()] - points[i]).squaredNorm());
  return std::sqrt(std::numbers::pi * upper_median(std::move(squares)) / median_of_gamma);
}

}  // namespace

ScanRegion make_scan_region(PlaneRegion region,
                            std::span<const Eigen::Vector3d> points,
                            const PointNeighbours& neighbours) {
  constexpr double kUpright_deg = 75.0;
  ScanRegion result;
  result.fit = region.fit;
  result.points = std::move(region.points);
  const Eigen::Vector3d n = result.fit.plane.normal();
  const double slope = slope_rad(result.fit.plane);
  result.is_upright = slope > kUpright_deg * kRadPerDeg;
  Eigen::Vector3d u = result.fit.axes.col(0);
  if (slope >= kLevelRoof_rad) u = Eigen::Vector3d::UnitZ().cross(n).normalized();
  result.axes << u, n.cross(u);
  result.uv.reserve(result.points.size());
  for (const std::size_t i : result.points) result.uv.push_back(result.in_plane(points[i]));
  result.spacing_m = spacing_m_of(result.points, points, neighbours);
  return result;
}

std::vector<CellSide> coarse_border(const ScanRegion& region) {
  constexpr double kCellSpacings = 2.5;  // one cell of 500 within random points is empty
  const double cell_m = kCellSpacings * region.spacing_m;
  std::vector<std::pair<long, long>> cells;
  cells.reserve(region.uv.size());
  for (const Eigen::Vector2d& x : region.uv)
    cells.emplace_back(std::lround(x.x() / cell_m), std::lround(x.y() / cell_m));
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<CellSide> sides;
  for (const auto& [column, row] : cells) {
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
      if (std::ranges::binary_search(cells, std::pair(column + dx, row + dy))) continue;
      const Eigen::Vector2d middle(static_cast<double>(column), static_cast<double>(row));
      const Eigen::Vector2d out(dx, dy);
      sides.push_back({cell_m * (middle + 0.5 * out), out});
    }
  }
  return sides;
}

}  // namespace ridgeline::evaluate
