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

/// The ideal (undistorted) pixel of a pixel of the file, or nothing outside of the field for which
/// the distortion is known. An empty function means that both are the same.
using PixelMap = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>;

/// Appearance of a strip along one side of an edge: means of the normalised image (0 dark, 1
/// bright).
struct Flank {
  std::array<float, 4> colour{};  ///< per band; 0 where the image has fewer bands
  float grey = 0.0F;              ///< mean over the bands
};

/// A straight edge of an image. It runs from start to end with its brighter side (grey) on the
/// right, which for u = end - start is the side that n = (-u_y, u_x) points to (y runs down).
struct EdgeSegment {
  UncertainSegment2 line;  ///< ideal pixels: the distortion of the lens is removed
  Segment2 in_image;       ///< the segment in pixels of the file, where the image is sampled
  Flank left, right;
  int n_edge_pixels = 0;
  double rms_px = 0.0;    ///< root mean square distance of the edge pixels from the line
  double contrast = 0.0;  ///< mean strength of the colour gradient along the edge, 1/px
  double scale_px = 1.0;  ///< pixels of the view per pixel of the reduced image it was found in
  bool guided = false;    ///< whether it was found where a segment of another view predicted it
};

/// The segments of a view without the guided ones, which are its last.
inline std::span<const EdgeSegment> extracted(const std::vector<EdgeSegment>& segments) {
  return {segments.begin(), std::ranges::find_if(segments, &EdgeSegment::guided)};
}

/// The flanks of a right segment on the left and the right of its left counterpart's direction.
/// @param reversed  the right segment runs against the left one, so that its flanks change sides
inline std::array<const Flank*, 2> counterpart_flanks(const EdgeSegment& right, bool reversed) {
  if (reversed) return {&right.right, &right.left};
  return {&right.left, &right.right};
}

}  // namespace ridgeline
