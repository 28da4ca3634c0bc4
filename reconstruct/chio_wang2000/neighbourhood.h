// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/core.h"
#include "reconstruct/chio_wang2000/structures.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A segment whose height may constrain another's.
struct Neighbour {
  int left = 0;
  std::optional<Eigen::Vector2d> junction_px;  ///< where the two meet
  double distance_px = 0.0;
};

/// By left segment: its neighbours, nearest first.
using Neighbourhood = std::vector<std::vector<Neighbour>>;

/// Members of the same structure, those of the strongest structure first.
Neighbourhood adjacent_segments(std::span<const Segment2> segments,
                                std::span<const Structure> structures);

/// Segments closer than `range_m` in the image, by the size of its ground pixels; none for 0.
Neighbourhood segments_in_range(std::span<const Segment2> segments,
                                std::span<const CoreCandidates> candidates,
                                double range_m);

}  // namespace ridgeline::reconstruct
