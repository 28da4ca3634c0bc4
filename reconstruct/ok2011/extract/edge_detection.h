// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/extract/edge_pixels.h"
#include "reconstruct/ok2011/extract/noise_grid.h"
#include "reconstruct/ok2011/extract/options.h"

namespace ridgeline::reconstruct {

/// The colour gradient of an image and how strong it is without edges.
struct GradientImage {
  cv::Mat gradient;  ///< CV_32FC2, 1/px
  NoiseGrid noise;
};
GradientImage gradient_image(const cv::Mat& image, const ExtractOptions& options);

/// Edge pixels of the image after diffusion that are stronger than the low threshold; the border of
/// one pixel has none. Where exactly an edge runs is to be measured in the gradient of the image
/// itself: diffusion, like all that sharpens, draws edges to the middles of pixels.
/// Works in square tiles in parallel; the order is that of the tiles, rows in a tile.
std::vector<EdgePixel> detected_edge_pixels(const cv::Mat& image,
                                            const NoiseGrid& noise,
                                            const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
