// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/options.h"
#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// Segments of a detector of OpenCV in the grey image, the mean of the bands in 8 bit, with the
/// parameters that OpenCV proposes; pixel (0,0) is the centre of the first pixel. Shorter ones than
/// `min_length_px` are left out. `options.detector` is one of
///   kLsd          von Gioi et al. 2010. It works in the image reduced to 0.8 and comes back without
///                 the half pixel, so all is 0.5 / 0.8 - 0.5 = 0.125 px up and left; undone here.
///   kEdgeDrawing  Akinlar & Topal 2011.
/// `image`: CV_32FC(n) in [0, 1].
std::vector<Segment2> opencv_segments(const cv::Mat& image, const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
