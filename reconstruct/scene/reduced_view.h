// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// A view whose image has one pixel for each block of `factor` x `factor` pixels: their mean.
/// Camera, distortion and segments are in the new pixels. Blocks are counted from the corner of the
/// frame that the image is cut from, so that windows of one frame have the same blocks. What does
/// not fill a block is left out. A new pixel is valid if its whole block is.
/// @param view    its image is CV_32F
/// @param factor  1 or more; 1 returns the view
/// @return the reduced view; its image is empty if no block fits into that of the view
View reduced(const View& view, int factor);

/// The homography from pixels of reduced(view, factor), ideal or of the file, to those of the view.
Eigen::Matrix3d image_from_reduced(const View& view, int factor);

/// Segments of reduced(view, factor) in the pixels of the view.
std::vector<EdgeSegment> in_pixels_of(const View& view,
                                      int factor,
                                      std::vector<EdgeSegment> segments);

/// A segment of the reduced image in the pixels of the image.
Segment2 in_pixels_of(const View& view, int factor, const Segment2& segment);

/// The view reduced to the pixels in which its sharpest segment was found (EdgeSegment::scale_px).
/// A view without segments stays as it is.
View at_scale_of_edges(const View& view);

/// The factor of at_scale_of_edges(), 1 or more.
int scale_of_edges(const View& view);

}  // namespace ridgeline::reconstruct
