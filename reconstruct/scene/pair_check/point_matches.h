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

/// Points visible in both images, matched only by their appearance. The search is not restricted by
/// cameras or heights, so the points can be used to check the cameras. They are SIFT points (Lowe
/// 2004) in images reduced to half their size, but to a longer side of at least 500 and at most
/// 1500 pixels. A match is the best one in both directions and clearly better than the second best.
/// Most matches are correct, but not all; they are accurate to about half a pixel of the reduced
/// image. The images may be rotated and differ in scale. `images`: CV_32FC(n) in [0, 1]. Images
/// without texture give no points.
std::vector<PointMatch> match_points(const std::array<cv::Mat, 2>& images);

}  // namespace ridgeline::reconstruct
