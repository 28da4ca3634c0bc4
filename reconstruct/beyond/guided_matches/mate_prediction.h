// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace ridgeline::reconstruct {

/// Tells where segments of one view are seen in the other one, if they bound a surface.
class MatePrediction {
 public:
  /// @param from  the view of the segments: 0 left, 1 right
  MatePrediction(const Surface& surface, std::size_t from);

  /// On the nearer surface, which a line bounds; ideal pixels, in the direction of the segment. Nothing where that surface
  /// is not to be trusted, and near the direction of the base (10 degrees), where a shift along the line changes nothing.
  [[nodiscard]] std::optional<Segment2> of(const Segment2& segment) const;

 private:
  Surface surface_;  ///< as the view of the segments shows it
  double moved_px_ =
      0.0;  ///< along the rows, to keep the pixels of the right view in the frame of the left one
  std::size_t from_;
  Eigen::Matrix3d ideal_from_rectified_;  ///< of the other view
};

}  // namespace ridgeline::reconstruct
