// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// A view whose image has one pixel, the mean, for each block of `factor` x `factor` pixels.
/// Camera, distortion and segments refer to the new pixels. Blocks are counted from the corner of
/// the frame from which the image is cut, so that windows of one frame have the same blocks. Pixels
/// that do not fill a block are left out. A new pixel is valid if its whole block is valid.
/// @param view    its image is CV_32F
/// @param factor  1 or more; 1 returns the view
/// @return the reduced view; its image is empty if no block fits into the image of the view
View reduced(const View& view, int factor);

/// The homography from pixels (ideal or file) of reduced(view, factor) to those of the view.
Eigen::Matrix3d image_from_reduced(const View& view, int factor);

/// Converts segments of reduced(view, factor) to pixels of the view.
std::vector<EdgeSegment> in_pixels_of(const View& view,
                                      int factor,
                                      std::vector<EdgeSegment> segments);

/// Converts a segment of reduced(view, factor) to pixels of the view.
Segment2 in_pixels_of(const View& view, int factor, const Segment2& segment);

/// The view reduced to the pixel size at which its sharpest segment was found
/// (EdgeSegment::scale_px). A view without segments is returned unchanged.
View at_scale_of_edges(const View& view);

/// The factor of at_scale_of_edges(), 1 or more.
int scale_of_edges(const View& view);

}  // namespace ridgeline::reconstruct
