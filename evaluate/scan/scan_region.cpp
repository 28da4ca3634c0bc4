// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/scan_region.h"

#include "reconstruct/geometry/faces/roof_edge.h"

#include <Eigen/Geometry>

#include <utility>

namespace ridgeline::evaluate {

ScanRegion make_scan_region(PlaneRegion region, std::span<const Eigen::Vector3d> points) {
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
  result.shape = alpha_shape(result.uv);
  return result;
}

}  // namespace ridgeline::evaluate
