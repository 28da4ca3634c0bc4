// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_pixels.h"

#include "reconstruct/geometry/parabola.h"

#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

float strength(const cv::Vec2f& gradient) { return std::sqrt(gradient.dot(gradient)); }

}  // namespace

float peak_offset_px(float before, float middle, float after) {
  static constexpr float kFloor = 1e-12F;  // keeps the logarithm of a flat neighbour finite
  const auto log = [](float value) { return std::log(std::max(value, kFloor)); };
  return vertex_of_parabola(log(before), log(middle), log(after));
}

std::optional<EdgePixel> edge_pixel_at(const cv::Mat& gradient, int x, int y, float min_strength) {
  const auto& g = gradient.at<cv::Vec2f>(y, x);
  if (!(g.dot(g) > min_strength * min_strength)) return std::nullopt;
  const bool along_x = std::abs(g[0]) > std::abs(g[1]);
  const cv::Point step = along_x ? cv::Point(1, 0) : cv::Point(0, 1);
  const cv::Point middle(x, y);
  const float s = strength(g);
  const float before = strength(gradient.at<cv::Vec2f>(middle - step));
  const float after = strength(gradient.at<cv::Vec2f>(middle + step));
  if (s < before || s <= after) return std::nullopt;
  const float offset = peak_offset_px(before, s, after);
  const Eigen::Vector2f position(static_cast<float>(x) + offset * static_cast<float>(step.x),
                                 static_cast<float>(y) + offset * static_cast<float>(step.y));
  return EdgePixel{x, y, position, {g[0], g[1]}};
}

}  // namespace ridgeline::reconstruct
