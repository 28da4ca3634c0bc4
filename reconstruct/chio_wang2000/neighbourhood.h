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
  /// Where the two segments meet; empty in segments_in_range().
  std::optional<Eigen::Vector2d> junction_px;
  double distance_px = 0.0;
};

/// The neighbours of each left segment, in the order in which they are tried.
using Neighbourhood = std::vector<std::vector<Neighbour>>;

/// The neighbours of each segment in its structures: their other members. Those of the strongest structure come first.
Neighbourhood adjacent_segments(std::span<const Segment2> segments,
                                std::span<const Structure> structures);

/// The neighbours of each segment within `range_m`, nearest first. The range is converted to pixels by the size
/// of the segment's pixels on the ground. There are none for a range of 0 or a segment without candidates.
Neighbourhood segments_in_range(std::span<const Segment2> segments,
                                std::span<const CoreCandidates> candidates,
                                double range_m);

}  // namespace ridgeline::reconstruct
