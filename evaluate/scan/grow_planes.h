// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_fit.h"
#include "evaluate/scan/neighbours.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Connected points on a plane.
struct PlaneRegion {
  PlaneFit fit;
  std::vector<std::size_t> points;  ///< indices, ascending
};

/// Points without a region.
inline constexpr int kNoRegion = -1;

struct PlaneRegions {
  std::vector<PlaneRegion> regions;
  std::vector<int> region_of;  ///< by point; kNoRegion for the others
};

/// Divides points into planes: regions are grown from the flattest neighbourhood on, by normal and
/// distance; the points that remain join the plane next to them; planes that continue each other
/// are united; points near the line where two planes meet go to the one on whose side they lie.
/// Regions of fewer than 12 points are dropped.
PlaneRegions grow_planes(std::span<const Eigen::Vector3d> points,
                         const PointNeighbours& neighbours);

/// How often a point of one region is a neighbour of a point of another, by their numbers,
/// ascending.
std::map<std::pair<int, int>, int> contacts_of(std::span<const int> region_of,
                                               const PointNeighbours& neighbours);

}  // namespace ridgeline::evaluate
