// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline {

/// Maps a pixel of the file to its ideal (undistorted) pixel; std::nullopt outside the field for
/// which the distortion is known. An empty function means that the image has no distortion.
using PixelMap = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>;

/// Appearance of a strip along one side of an edge: means of the normalised image (0 dark, 1
/// bright).
struct Flank {
  std::array<float, 4> colour{};  ///< per band; 0 where the image has fewer bands
  float grey = 0.0F;              ///< mean over the bands
};

/// A straight edge of an image. It is directed so that its brighter side (grey) is on the right,
/// the side to which n = (-u_y, u_x) points for u = end - start (y runs down).
struct EdgeSegment {
  UncertainSegment2 line;  ///< ideal pixels (lens distortion removed)
  Segment2 in_image;       ///< the segment in file pixels, where the image is sampled
  Flank left, right;
  int n_edge_pixels = 0;
  double rms_px = 0.0;    ///< root mean square distance of the edge pixels from the line
  double contrast = 0.0;  ///< mean strength of the colour gradient along the edge, 1/px
  double scale_px = 1.0;  ///< view pixels per pixel of the reduced image in which it was found
  bool guided = false;    ///< whether it was found where a segment of another view predicted it
};

/// The segments of a view without the guided ones, which come last.
inline std::span<const EdgeSegment> extracted(const std::vector<EdgeSegment>& segments) {
  return {segments.begin(), std::ranges::find_if(segments, &EdgeSegment::guided)};
}

/// The flanks of a right segment, ordered as left and right of its left counterpart.
/// @param reversed  the right segment runs in the opposite direction, so its flanks are swapped
inline std::array<const Flank*, 2> counterpart_flanks(const EdgeSegment& right, bool reversed) {
  if (reversed) return {&right.right, &right.left};
  return {&right.left, &right.right};
}

}  // namespace ridgeline
