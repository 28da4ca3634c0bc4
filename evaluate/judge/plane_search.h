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
/// best plane of the remaining ones, until fewer than `min_points` agree. Each is refined by total
/// least squares in double. Walls (steeper than max_slope_deg) use up their points but are not
/// returned.
///
/// The result depends only on the points: PCL's random generator has a fixed seed, sampling
/// continues until the best plane has almost certainly been drawn, and the points are visited in an
/// order that depends only on their number. The plane found is refined until its points stay the
/// same.
///
/// If normals are given, the consensus takes them into account too; see PointNormals. The
/// refinement and the inliers depend only on the distance.
std::vector<FoundPlane> search_planes(std::span<const ZonePoint> side,
                                      const JudgeOptions& options,
                                      const PointNormals& normals = {});

}  // namespace ridgeline::evaluate
