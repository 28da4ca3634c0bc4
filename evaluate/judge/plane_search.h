// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/plane_fit.h"
#include "evaluate/judge/point_normals.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A plane found among the points of one side of a line.
struct FoundPlane {
  PlaneFit fit;
  std::vector<ZonePoint> inliers;
};

/// Planes of one side by sequential PCL sample consensus: the best plane of the points, then the
/// best of the rest, until fewer than `min_points` agree. Each is refined by total least squares in
/// double. Walls (steeper than max_slope_deg) use up their points but are not returned.
///
/// Nothing but the points decides: PCL's generator has a fixed seed, draws until it is all but
/// certain that it has met the best plane, and meets the points in an order that depends on their
/// number alone. The plane found is refined until its points stay the same.
///
/// With normals the consensus takes these into account too, see PointNormals. The refinement and
/// the inliers go by distance alone.
std::vector<FoundPlane> search_planes(std::span<const ZonePoint> side,
                                      const JudgeOptions& options,
                                      const PointNormals& normals = {});

}  // namespace ridgeline::evaluate
