// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/overlay_canvas.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <vector>

namespace ridgeline::apps {
namespace {

constexpr int kEnlarged = 2;  // display pixels per image pixel

}  // namespace

cv::Mat overlay_canvas(const cv::Mat& image) {
  std::vector<cv::Mat> bands;
  cv::split(image, bands);
  const std::size_t last = bands.size() < 3 ? 0 : 2;
  const std::vector<cv::Mat> shown{bands[last], bands[last / 2], bands[0]};
  cv::Mat merged;
  cv::merge(shown, merged);
  cv::Mat canvas;
  merged.convertTo(canvas, CV_8UC3, 255.0);
  cv::resize(canvas, canvas, {}, kEnlarged, kEnlarged, cv::INTER_LINEAR);
  return canvas;
}

cv::Point on_canvas(const Eigen::Vector2d& x_px) {
  // the centre of pixel 0 is at the display coordinate (kEnlarged - 1) / 2
  const Eigen::Array2d x = kEnlarged * (x_px.array() + 0.5) - 0.5;
  constexpr double kScale = 1U << static_cast<unsigned>(kCanvasFractionBits);
  return {cvRound(x.x() * kScale), cvRound(x.y() * kScale)};
}

}  // namespace ridgeline::apps
