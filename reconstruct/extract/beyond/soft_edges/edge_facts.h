// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// Statistics of the segments of one scale (EdgeSegment::scale_px).
struct EdgesOfScale {
  int scale_px = 1;  ///< 1: the image itself, 2: at half size, ...
  std::size_t n_segments = 0;
  double length_px = 0.0;  ///< total length, pixels of the image
  /// Median standard deviation of the blur of their edges, pixels of the image, at most 6 scale_px;
  /// std::nullopt with fewer than five clean edges.
  std::optional<double> width_px{};
};

/// Sharpness of the edges of an image and noise of its pixels.
struct EdgeFacts {
  std::vector<EdgesOfScale> scales;  ///< the finest first; empty without segments
  /// Standard deviation of the grey value of a pixel, in units of the range of grey values;
  /// std::nullopt for an image without data.
  std::optional<double> noise{};
};

/// @param view  its image comes from normalised(); it has segments
EdgeFacts edge_facts(const View& view);

}  // namespace ridgeline::reconstruct
