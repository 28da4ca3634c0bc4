// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edge_pixels.h"

#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

float strength(const cv::Vec2f& gradient) { return std::sqrt(gradient.dot(gradient)); }

}  // namespace

float peak_offset_px(float before, float middle, float after) {
  constexpr float kFloor = 1e-12F;  // an exactly flat neighbour has no logarithm
  const float a = std::log(std::max(before, kFloor));
  const float b = std::log(std::max(middle, kFloor));
  const float c = std::log(std::max(after, kFloor));
  const float curvature = 2.0F * b - a - c;
  if (curvature <= 0.0F) return 0.0F;
  return std::clamp(0.5F * (c - a) / curvature, -0.5F, 0.5F);
}

std::vector<EdgePixel> edge_pixels(const cv::Mat& gradient, float min_strength) {
  std::vector<EdgePixel> pixels;
  for (int y = 1; y + 1 < gradient.rows; ++y) {
    const auto* row = gradient.ptr<cv::Vec2f>(y);
    for (int x = 1; x + 1 < gradient.cols; ++x) {
      const cv::Vec2f& g = row[x];
      if (g.dot(g) < min_strength * min_strength || g.dot(g) == 0.0F) continue;
      const bool along_x = std::abs(g[0]) > std::abs(g[1]);
      const float before = strength(along_x ? row[x - 1] : gradient.at<cv::Vec2f>(y - 1, x));
      const float after = strength(along_x ? row[x + 1] : gradient.at<cv::Vec2f>(y + 1, x));
      const float middle = strength(g);
      if (middle < before || middle <= after) continue;
      const float offset = peak_offset_px(before, middle, after);
      const Eigen::Vector2f shift =
          along_x ? Eigen::Vector2f(offset, 0) : Eigen::Vector2f(0, offset);
      pixels.push_back({x, y, Eigen::Vector2f(float(x), float(y)) + shift, {g[0], g[1]}});
    }
  }
  return pixels;
}

}  // namespace ridgeline::reconstruct
