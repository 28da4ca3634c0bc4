// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::reconstruct {

/// One point in the left and the right image; pixel (0,0) is the centre of the top-left pixel.
struct PointMatch {
  std::array<Eigen::Vector2d, 2> x_px;
};

/// Points that both images show, found by their appearance alone. No camera and no height limits
/// the search, so the points tell whether the cameras are right. They are SIFT points (Lowe 2004)
/// in images reduced to half, to at least 500 and at most 1500 pixels a side. A match is the best
/// one in both directions and clearly better than the next one. Most matches are right, some are
/// not; they are exact to about half a pixel of the reduced image. The images may be turned and of
/// different scale. `images`: CV_32FC(n) in [0, 1]. Images without texture give no points.
std::vector<PointMatch> match_points(const std::array<cv::Mat, 2>& images);

}  // namespace ridgeline::reconstruct
