// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_pixels.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Indices of edge pixels in order along an edge.
using Chain = std::vector<int>;

/// Index of the edge pixel at each pixel of the image, -1 where there is none: CV_32SC1.
cv::Mat edge_pixel_index(std::span<const EdgePixel> pixels, const cv::Size& size_px);

/// Links edge pixels into chains. Each pixel selects the nearest pixel ahead of it and the nearest
/// behind it along its edge, within two pixels; edge directions are compared modulo 180 degrees.
/// Two pixels that select each other are linked. A chain therefore passes straight through a
/// junction, and a branch starts a chain of its own. Every pixel is in exactly one chain; a closed
/// chain is opened at its first pixel in raster order.
std::vector<Chain> linked_chains(std::span<const EdgePixel> pixels, const cv::Mat& index);

}  // namespace ridgeline::reconstruct
