// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/match/chio_wang2000/core.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/match/chio_wang2000/structures.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A segment whose height may constrain that of another one.
struct Neighbour {
  int left = 0;
  /// Where the two segments meet; empty in segments_in_range().
  std::optional<Eigen::Vector2d> junction_px;
  double distance_px = 0.0;
};

/// The neighbours of each left segment, in the order in which they are tried.
using Neighbourhood = std::vector<std::vector<Neighbour>>;

/// The neighbours of each segment: the other members of its structures. Those of the strongest
/// structure come first.
Neighbourhood adjacent_segments(std::span<const Segment2> segments,
                                std::span<const Structure> structures);

/// The neighbours of each segment within `range_m`, nearest first. The range is converted to pixels
/// by the ground size of a pixel at the segment. A segment has no neighbours if the range is 0 or
/// if it has no candidates.
Neighbourhood segments_in_range(std::span<const Segment2> segments,
                                std::span<const CoreCandidates> candidates,
                                double range_m);

/// Compares the height of a candidate with that of a matched neighbour. Without a noise allowance,
/// the mean heights of both lines are compared. With one, the heights where the two lines meet are
/// compared or, if they do not meet, the gap between their height ranges counts, and the noise of
/// both widens the limit.
class NeighbourHeights {
 public:
  /// Both arguments must live as long as this object.
  NeighbourHeights(std::span<const Segment2> left_segments,
                   const std::optional<NoiseAllowance>& noise)
      : left_segments_(left_segments), noise_(noise) {}

  /// The height of the neighbour that a candidate is compared with.
  /// @param counterpart  the candidate that the neighbour has taken
  [[nodiscard]] double height_of(const Neighbour& neighbour,
                                 const CoreCandidate& counterpart) const;

  /// Whether a candidate of a left segment and the segment's neighbour agree in height to within a
  /// limit.
  [[nodiscard]] bool agree(int left,
                           const CoreCandidate& candidate,
                           const Neighbour& neighbour,
                           const CoreCandidate& counterpart,
                           double limit_m) const;

 private:
  [[nodiscard]] double height_at(int left,
                                 const CoreCandidate& candidate,
                                 const Eigen::Vector2d& x_px) const;

  std::span<const Segment2> left_segments_;
  const std::optional<NoiseAllowance>& noise_;
};

}  // namespace ridgeline::reconstruct
