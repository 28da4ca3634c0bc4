// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"
#include "evaluate/judge/point_normals.h"
#include "evaluate/line_evaluation.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The planes that could judge a line: those of both sides and of what is left, each extended over
/// its connected points of the zone, fitted again and united where they turn out to be the same;
/// and a ledge along the line. Surfaces that let the laser through (tree canopies) are left out;
/// cars and the like are marked as low objects, unless the images show that the line is their edge.
std::vector<CandidatePlane> candidate_planes(std::span<const ZonePoint> zone,
                                             const Footprint& footprint,
                                             const std::optional<ImageEvidence>& images,
                                             const JudgeOptions& options,
                                             std::uint64_t key,
                                             const PointNormals& normals = {});

}  // namespace ridgeline::evaluate
