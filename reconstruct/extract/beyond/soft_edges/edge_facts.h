// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of one scale (EdgeSegment::scale_px).
struct EdgesOfScale {
  int scale_px = 1;  ///< 1: the image itself, 2: at half size, ...
  std::size_t n_segments = 0;
  double length_px = 0.0;  ///< of all of them, pixels of the image
  /// Median standard deviation of the blur of their edges, pixels of the image, at most 6 scale_px;
  /// nothing with fewer than five clean edges.
  std::optional<double> width_px{};
};

/// How sharp the edges of an image are, and how noisy its pixels.
struct EdgeFacts {
  std::vector<EdgesOfScale> scales;  ///< the finest first; empty without segments
  /// Standard deviation of a pixel's grey value, of a range of 1; nothing for an image without
  /// data.
  std::optional<double> noise{};
};

/// @param view  its image is as normalised() makes it; it has segments
EdgeFacts edge_facts(const View& view);

}  // namespace ridgeline::reconstruct
