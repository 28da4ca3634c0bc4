// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// Strengths are in multiples of the local noise: the typical strength of the gradient away from
/// edges (NoiseGrid).
struct ExtractOptions {
  bool diffusion = true;           ///< before detection, except for faint edges
  double gradient_sigma_px = 0.8;  ///< larger values lose close edges, smaller ones are noisier
  double low_noise_factor = 1.0;   ///< minimum strength of an edge pixel
  double high_noise_factor = 2.0;  ///< minimum strength of the strongest pixel of an edge
  double max_deviation_px = 1.0;   ///< straightness: maximum distance from the line
  double min_length_px = 10.0;
  /// Systematic parts of the stated uncertainty. The apparent position of an edge depends on the
  /// tone curve of the image and on details too small to be resolved (gutters, ridge caps). The
  /// values are calibrated on rendered roofs, where the tone curve by itself shifts eaves by 0.1 px
  /// towards the dark side.
  double systematic_across_px = 0.1;  ///< sigma across the line at its centroid
  double systematic_ends_px = 0.02;   ///< sigma of an end across the line, relative to the centroid

  static constexpr auto fields() {
    using O = ExtractOptions;
    return std::tuple{
        Field{"gradient_sigma_px", &O::gradient_sigma_px, 0.5, 5.0,
              "smoothing of the colour gradient"},
        Field{"low_noise_factor", &O::low_noise_factor, 0.0, 1e3,
              "minimum strength of an edge pixel, in multiples of the noise"},
        Field{"high_noise_factor", &O::high_noise_factor, 0.0, 1e3,
              "minimum strength of the strongest pixel of an edge, in multiples of the noise"},
        Field{"max_deviation_px", &O::max_deviation_px, 0.1, 100.0,
              "straightness: maximum distance of an edge pixel from the line"},
        Field{"min_length_px", &O::min_length_px, 3.0, 1e5, "minimum length of a segment"},
        Field{"systematic_across_px", &O::systematic_across_px, 0.0, 10.0,
              "systematic part of the sigma across a segment"},
        Field{"systematic_ends_px", &O::systematic_ends_px, 0.0, 10.0,
              "systematic part of the sigma of one segment end relative to the other"}};
  }
};

}  // namespace ridgeline::reconstruct
