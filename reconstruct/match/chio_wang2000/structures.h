// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A linear structure (Chio and Wang 2000): a junction with its neighbouring segments.
struct Structure {
  Eigen::Vector2d junction_px;
  std::vector<int> members;   ///< at least two segments, ascending
  double length_px = 0.0;     ///< total length of the members
  double precision_px = 0.0;  ///< mean distance of the members from the junction
};

/// The structures of an image, strongest first: by number of members, then length, then precision
/// (the paper calls its weighting simple but does not give it; this one is ours). Two segments meet
/// where their lines intersect at 20 degrees or more, within 5 px of an end of one and within 5 px
/// of the other segment (L and T junctions); meetings within 5 px of each other form one junction.
std::vector<Structure> linear_structures(std::span<const Segment2> segments);

/// The indices of the structures of each segment, ascending.
std::vector<std::vector<int>> structures_of_segments(std::span<const Structure> structures,
                                                     std::size_t n_segments);

}  // namespace ridgeline::reconstruct
