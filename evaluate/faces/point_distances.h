// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/point_search.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// How far the laser points of a building are from its model, in metres.
struct PointDistances {
  std::vector<double> to_surface_m;  ///< of each point from the nearest roof, wall or ground
  /// Points over the roof, ground included, and of these those that lie more than 1.5 m below all
  /// of it.
  int n_over = 0, n_far_below = 0;
  /// Vertically from the nearest roof above or below, of the points over the roof; without those
  /// that a ray past the roof meets.
  std::vector<double> to_roof_m;
  double over_squares_m2 =
      0.0;  ///< sum of the squares of the heights between all points over the roof and it
  /// How far the points over the roof lie below it, if they have its shape: the middle two thirds
  /// within 0.15 m of each other's median. Negative above it.
  std::optional<double> parallel_below_m;
  /// Median height of the points over the roof above the lower ones beside it; empty without points
  /// beside it.
  std::optional<double> above_ground_m;
};

/// Of each building the points over its roof and up to 0.5 m beside it in plan. A point's nearest
/// surface may be that of a building that touches. Noise, vegetation and water are left out by
/// their class. The ground is left out beside the roof, and from the distances to it; points
/// without a class are taken for ground up to 0.5 m above the building's lowest vertex. Points at
/// the same place are one. In parallel; the result does not depend on the number of threads.
/// @param classes  ASPRS, by PointSearch::Point::index; may be empty
std::vector<PointDistances> point_distances(const PointSearch& search,
                                            std::span<const RoofBuilding> buildings,
                                            std::span<const std::uint8_t> classes);

}  // namespace ridgeline::evaluate
