// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/soft_edges/edge_facts.h"

#include "reconstruct/extract/ok2011/edge_blur.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/scene/reduced_view.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <map>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Estimates the noise from second differences in both directions, in which edges have little
/// influence (Immerkaer 1996, with a median instead of the mean).
std::optional<double> noise_of(const cv::Mat& image, const cv::Mat& is_valid) {
  constexpr double kMedianOfNormal = 0.6745;
  const cv::Matx33f differences(1, -2, 1, -2, 4, -2, 1, -2, 1);  // noise of sigma 1 gives sigma 6
  constexpr double kGain = 6.0;
  cv::Mat grey;
  cv::transform(image, grey, cv::Mat(1, image.channels(), CV_32F, 1.0 / image.channels()));
  cv::filter2D(grey, grey, CV_32F, differences, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  std::vector<float> sizes;
  sizes.reserve(grey.total());
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      if (is_valid.empty() || is_valid.at<unsigned char>(y, x) != 0)
        sizes.push_back(std::abs(grey.at<float>(y, x)));
    }
  }
  if (sizes.empty()) return std::nullopt;
  return upper_median(std::move(sizes)) / (kGain * kMedianOfNormal);
}

/// @param view  only has the segments of this scale
EdgesOfScale edges_of_scale(const View& view, int scale_px) {
  EdgesOfScale edges{.scale_px = scale_px, .n_segments = view.segments.size()};
  for (const EdgeSegment& segment : view.segments) edges.length_px += length(segment.in_image);
  const View smaller = reduced(view, scale_px);
  edges.width_px = blur_of_longest_px(smaller.image, smaller.segments);
  if (edges.width_px) *edges.width_px *= scale_px;
  return edges;
}

}  // namespace

EdgeFacts edge_facts(const View& view) {
  std::map<int, std::vector<EdgeSegment>> by_scale;
  for (const EdgeSegment& segment : view.segments)
    by_scale[static_cast<int>(segment.scale_px)].push_back(segment);
  EdgeFacts facts;
  View of_scale = view;
  for (auto& [scale_px, segments] : by_scale) {
    of_scale.segments = std::move(segments);
    facts.scales.push_back(edges_of_scale(of_scale, scale_px));
  }
  facts.noise = noise_of(view.image, view.is_valid);
  return facts;
}

}  // namespace ridgeline::reconstruct
