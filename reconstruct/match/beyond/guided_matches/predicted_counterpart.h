// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/surface/surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace ridgeline::reconstruct {

/// Predicts where the other view shows segments of one view, assuming that they bound a surface.
class PredictedCounterpart {
 public:
  /// @param from  the view of the segments: 0 left, 1 right
  PredictedCounterpart(const Surface& surface, std::size_t from);

  /// The segment in the other view, in ideal pixels and in the direction of the given one. It is
  /// assumed to lie on the nearer surface, which a line bounds. Empty if that surface is not
  /// trusted, or if the segment is within 10 degrees of the direction of the base, where a shift
  /// along the line changes nothing.
  [[nodiscard]] std::optional<Segment2> of(const Segment2& segment) const;

 private:
  Surface surface_;  ///< the surface as seen from the view of the segments
  /// Shift along the rows that keeps the pixels of the right view in the frame of the left one.
  double moved_px_ = 0.0;
  std::size_t from_;
  Eigen::Matrix3d ideal_from_rectified_;  ///< homography of the other view
};

}  // namespace ridgeline::reconstruct
