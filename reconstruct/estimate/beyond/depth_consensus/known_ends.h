// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/geometry/box_index.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The ends of lines of known height, by their position in each image. Eaves, ridges and streets
/// occur at few heights, so the heights of known ends are likely for nearby lines, too.
class KnownEnds {
 public:
  /// @param direct  the lines by the method `direct`, the intersection of two projection planes
  KnownEnds(const TrackedLines& lines, std::span<const ReconstructedLine> direct);

  /// Heights of the ends near a line of an image, in the conditioned object frame.
  [[nodiscard]] std::vector<double> heights_near(std::size_t view, const Segment2& seen_px) const;

 private:
  /// The ends as seen in one image.
  struct InImage {
    std::vector<Segment2> ends_px;  ///< segments of zero length
    BoxIndex2 index;
  };
  std::vector<double> heights_;  ///< by end, conditioned object frame
  std::vector<InImage> by_view_;
};

}  // namespace ridgeline::reconstruct
