// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment_index.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The ends of lines of known height, by their place in the left image. Eaves, ridges and streets come at few heights, so the
/// heights of known ends are likely for the lines nearby, too.
class KnownEnds {
 public:
  /// @param direct  the lines by the method `direct`, the intersection of two projection planes
  KnownEnds(const StereoLines& lines, std::span<const ReconstructedLine> direct);

  /// Heights of the ends near an image line, in the conditioned object frame.
  [[nodiscard]] std::vector<double> heights_near(const Segment2& seen_px) const;

 private:
  void add(const StereoViews& stereo, const Eigen::Vector3d& end_in_local);

  std::vector<Segment2> ends_px_;  ///< the ends, as segments of no length
  std::vector<double> heights_;    ///< by end, conditioned object frame
  SegmentIndex index_{{}};
};

}  // namespace ridgeline::reconstruct
