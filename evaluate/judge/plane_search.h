// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/plane_fit.h"
#include "evaluate/judge/point_normals.h"

#include <cstdint>
#include <span>
#include <string_view>
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
/// `key` seeds the order in which PCL draws samples (its own generator has a fixed seed), so the
/// result depends on the line and the run's seed, never on threads or on the order of lines.
///
/// With normals the consensus takes these into account too, see PointNormals. The refinement and the
/// inliers go by distance alone.
std::vector<FoundPlane> search_planes(std::span<const ZonePoint> side,
                                      const JudgeOptions& options,
                                      std::uint64_t key,
                                      const PointNormals& normals = {});

/// The key of a line: a hash of its id and the run's seed.
std::uint64_t line_key(std::string_view id, int seed);

}  // namespace ridgeline::evaluate
