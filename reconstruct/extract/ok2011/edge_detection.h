// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_pixels.h"
#include "reconstruct/extract/ok2011/image_part.h"
#include "reconstruct/extract/ok2011/noise_grid.h"
#include "reconstruct/extract/ok2011/options.h"

namespace ridgeline::reconstruct {

/// The colour gradient of an image and its strength away from edges.
struct GradientImage {
  cv::Mat gradient;  ///< CV_32FC2, 1/px
  NoiseGrid noise;
};
GradientImage gradient_image(const ImagePart& part, const ExtractOptions& options);

/// Edge pixels of the image after diffusion that are stronger than the low threshold; there are
/// none in the outermost rows and columns. The exact position of an edge must be measured in the
/// gradient of the image itself, because diffusion, like any sharpening, pulls edges towards pixel
/// centres. Square tiles are processed in parallel. The pixels are ordered by tile, then by row.
std::vector<EdgePixel> detected_edge_pixels(const cv::Mat& image,
                                            const NoiseGrid& noise,
                                            const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
