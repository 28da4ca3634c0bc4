// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edges_of_no_data.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

bool is_on_data(const Eigen::Vector2d& x_px, const cv::Mat& has_data) {
  const int column = std::clamp(static_cast<int>(std::lround(x_px.x())), 0, has_data.cols - 1);
  const int row = std::clamp(static_cast<int>(std::lround(x_px.y())), 0, has_data.rows - 1);
  return has_data.at<std::uint8_t>(row, column) != 0;
}

/// Whether most of a segment lies on data, tested once per pixel.
bool lies_on_data(const Segment2& segment, const cv::Mat& has_data) {
  const Eigen::Vector2d way = segment.end - segment.start;
  const int n = std::max(1, static_cast<int>(std::lround(way.norm())));
  int n_on_data = 0;
  for (int i = 0; i <= n; ++i) {
    if (is_on_data(segment.start + static_cast<double>(i) / n * way, has_data)) ++n_on_data;
  }
  return 2 * n_on_data > n;
}

/// Removes the samples at both ends that do not lie on data.
void trim(EdgeTrace& edge, const cv::Mat& has_data) {
  const auto is_kept = [&](const EdgeSample& sample) {
    return is_on_data(sample.position_px, has_data);
  };
  edge.erase(edge.begin(), std::ranges::find_if(edge, is_kept));
  while (!edge.empty() && !is_kept(edge.back())) edge.pop_back();
}

bool is_edge(const EdgeTrace& trimmed, const cv::Mat& has_data, double min_length_px) {
  constexpr std::size_t kMinSamples = 3;  // two always fit a line
  if (trimmed.size() < kMinSamples) return false;
  const Segment2 chord{trimmed.front().position_px, trimmed.back().position_px};
  return length(chord) >= min_length_px && lies_on_data(chord, has_data);
}

}  // namespace

cv::Mat far_from_no_data(const cv::Mat& is_valid) {
  if (is_valid.empty()) return {};
  constexpr int kReach_px = 6;
  constexpr int kSide_px = 2 * kReach_px + 1;
  cv::Mat has_data;
  cv::erode(is_valid, has_data,
            cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kSide_px, kSide_px)));
  return has_data;
}

std::vector<EdgeTrace> edges_on_data(std::vector<EdgeTrace> edges,
                                     const cv::Mat& has_data,
                                     double min_length_px) {
  if (has_data.empty()) return edges;
  for (EdgeTrace& edge : edges) trim(edge, has_data);
  std::erase_if(edges,
                [&](const EdgeTrace& edge) { return !is_edge(edge, has_data, min_length_px); });
  return edges;
}

void remove_edges_of_no_data(std::vector<EdgeSegment>& segments, const cv::Mat& has_data) {
  if (has_data.empty()) return;
  std::erase_if(segments, [&](const EdgeSegment& segment) {
    return !lies_on_data(segment.in_image, has_data);
  });
}

}  // namespace ridgeline::reconstruct
