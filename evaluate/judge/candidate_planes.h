// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"
#include "evaluate/judge/point_normals.h"
#include "evaluate/line_evaluation.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The planes that could judge a line. They are searched for among the points on each side of the
/// line, then among the points that these planes do not explain. Each is extended over its
/// connected points in the zone and fitted again, and duplicates of the same plane are merged. A
/// ledge along the line is added. Surfaces that let the laser through (tree canopies) are left out.
std::vector<CandidatePlane> candidate_planes(std::span<const ZonePoint> zone,
                                             const Footprint& footprint,
                                             const JudgeOptions& options,
                                             const PointNormals& normals = {});

}  // namespace ridgeline::evaluate
