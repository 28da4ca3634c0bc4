// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment_index.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The ends of lines of known height, by their place in the left image. Eaves, ridges and streets come at few heights, so that
/// these are likely for the lines nearby.
class KnownEnds {
 public:
  /// @param direct  lines by intersection of their planes
  KnownEnds(const StereoLines& lines, std::span<const ReconstructedLine> direct);

  /// Heights of the ends near an image line, in the conditioned object frame.
  [[nodiscard]] std::vector<double> heights_near(const Segment2& seen_px) const;

 private:
  void add(const StereoViews& stereo, const Eigen::Vector3d& end_in_local);

  std::vector<Segment2> ends_px_;  ///< of no length
  std::vector<double> heights_;
  SegmentIndex index_{{}};
};

}  // namespace ridgeline::reconstruct
