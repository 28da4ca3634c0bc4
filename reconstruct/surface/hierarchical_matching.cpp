// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/hierarchical_matching.h"

#include "reconstruct/surface/semi_global.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

/// An image of half the size, from the means of 2 x 2 pixels. An odd last row or column is cut off.
cv::Mat halved(const cv::Mat& image) {
  const cv::Size half(image.cols / 2, image.rows / 2);
  cv::Mat result;
  cv::resize(image(cv::Rect(cv::Point(), half * 2)), result, half, 0.0, 0.0, cv::INTER_AREA);
  return result;
}

/// @param n_halved  maximum number of times the views are halved
cv::Mat matched(const cv::Mat& left, const cv::Mat& right, int n_all, int n_halved) {
  constexpr int kMinSide_px = 32;
  const bool is_coarsest = n_halved == 0 || std::min(left.cols, left.rows) < kMinSide_px;
  return semi_global_disparities(
      left, right,
      is_coarsest ? all_disparities(left.size(), n_all)
                  : disparities_near(matched(halved(left), halved(right), n_all / 2, n_halved - 1),
                                     left.size(), n_all));
}

}  // namespace

cv::Mat hierarchical_disparities(const cv::Mat& left, const cv::Mat& right, int n_all) {
  return matched(left, right, n_all, 2);
}

}  // namespace ridgeline::reconstruct
