// SPDX-License-Identifier: BSD-3-Clause
#include "apps/extract/segment_overlay.h"

#include <opencv2/imgproc.hpp>

#include <array>

namespace ridgeline::apps {
namespace {

constexpr int kEnlarged = 2;      // display pixels per image pixel: segments may lie 2 px apart
constexpr int kFractionBits = 4;  // of the coordinates that OpenCV draws at
constexpr int kDotRadius = 2;

/// The first three bands, or the first one in grey, in OpenCV's order blue, green, red.
cv::Mat canvas_of(const cv::Mat& image) {
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

/// The centre of pixel 0 is at the display coordinate (kEnlarged - 1) / 2.
cv::Point on_canvas(const Eigen::Vector2d& x_px) {
  const Eigen::Array2d x = kEnlarged * (x_px.array() + 0.5) - 0.5;
  constexpr double kScale = 1U << static_cast<unsigned>(kFractionBits);
  return {cvRound(x.x() * kScale), cvRound(x.y() * kScale)};
}

}  // namespace

cv::Mat segment_overlay(const cv::Mat& image, const std::vector<EdgeSegment>& segments) {
  static const std::array<cv::Scalar, 6> colours{cv::Scalar(0, 255, 255), cv::Scalar(255, 255, 0),
                                                 cv::Scalar(0, 255, 0),   cv::Scalar(255, 0, 255),
                                                 cv::Scalar(0, 128, 255), cv::Scalar(255, 128, 0)};
  const cv::Scalar red(0, 0, 255);
  cv::Mat canvas = canvas_of(image);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const cv::Point start = on_canvas(segments[i].in_image.start);
    const cv::Point end = on_canvas(segments[i].in_image.end);
    const int radius = kDotRadius * (1 << kFractionBits);
    cv::line(canvas, start, end, colours[i % colours.size()], 1, cv::LINE_AA, kFractionBits);
    cv::circle(canvas, start, radius, red, cv::FILLED, cv::LINE_AA, kFractionBits);
    cv::circle(canvas, end, radius, red, cv::FILLED, cv::LINE_AA, kFractionBits);
  }
  return canvas;
}

}  // namespace ridgeline::apps
