// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edges_of_no_data.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Whether most of a segment lies where `has_data` is not 0, tested once per pixel.
bool lies_on_data(const Segment2& segment, const cv::Mat& has_data) {
  const Eigen::Vector2d way = segment.end - segment.start;
  const int n = std::max(1, static_cast<int>(std::lround(way.norm())));
  int n_on_data = 0;
  for (int i = 0; i <= n; ++i) {
    const Eigen::Vector2d x = segment.start + static_cast<double>(i) / n * way;
    const int column = std::clamp(static_cast<int>(std::lround(x.x())), 0, has_data.cols - 1);
    const int row = std::clamp(static_cast<int>(std::lround(x.y())), 0, has_data.rows - 1);
    n_on_data += has_data.at<std::uint8_t>(row, column) != 0;
  }
  return 2 * n_on_data > n;
}

}  // namespace

void remove_edges_of_no_data(std::vector<EdgeSegment>& segments, const cv::Mat& is_valid) {
  if (is_valid.empty()) return;
  constexpr int kReach_px = 3;
  constexpr int kSide_px = 2 * kReach_px + 1;
  cv::Mat has_data;
  cv::erode(is_valid, has_data,
            cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kSide_px, kSide_px)));
  std::erase_if(segments, [&](const EdgeSegment& segment) {
    return !lies_on_data(segment.in_image, has_data);
  });
}

}  // namespace ridgeline::reconstruct
