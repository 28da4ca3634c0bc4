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
  std::vector<double> to_surface_m;  ///< of each point to the nearest roof, wall or ground
  /// Number of points over the roof, including ground, and of those among them that lie more than
  /// 1.5 m below the part of the roof closest to them in height.
  int n_over = 0, n_far_below = 0;
  /// Vertical distances of the points over the roof to the closest roof above or below; without
  /// ground and without points that a ray passing the roof may have hit.
  std::vector<double> to_roof_m;
  double over_squares_m2 =
      0.0;  ///< sum of the squared vertical distances of all points over the roof from it
  /// Median of how far the points over the roof lie below it, negative above it; empty unless they
  /// follow its shape: the middle two thirds must span at most 0.3 m.
  std::optional<double> parallel_below_m;
  /// Median height of the points over the roof above the 30 % quantile of the heights beside it;
  /// empty if there are no points over or beside it.
  std::optional<double> above_ground_m;
};

/// For each building, the points over its roof and up to 0.5 m beside it in plan. The surface
/// nearest to a point may belong to an adjoining building. Noise, vegetation and water are excluded
/// by their class. Ground is excluded from to_surface_m beside the roof, and everywhere from
/// to_roof_m; points without a class are assumed to be ground up to 0.5 m above the building's
/// lowest vertex. Points at the same position count once. In parallel; the result does not depend
/// on the number of threads.
/// @param classes  ASPRS, by PointSearch::Point::index; may be empty
std::vector<PointDistances> point_distances(const PointSearch& search,
                                            std::span<const RoofBuilding> buildings,
                                            std::span<const std::uint8_t> classes);

}  // namespace ridgeline::evaluate
