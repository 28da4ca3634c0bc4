// SPDX-License-Identifier: BSD-3-Clause
#include "apps/extract/segment_overlay.h"

#include "apps/common/overlay_canvas.h"

#include <opencv2/imgproc.hpp>

#include <array>

namespace ridgeline::apps {
namespace {

constexpr int kDotRadius = 2;

}  // namespace

cv::Mat segment_overlay(const cv::Mat& image, const std::vector<EdgeSegment>& segments) {
  static const std::array<cv::Scalar, 6> colours{cv::Scalar(0, 255, 255), cv::Scalar(255, 255, 0),
                                                 cv::Scalar(0, 255, 0),   cv::Scalar(255, 0, 255),
                                                 cv::Scalar(0, 128, 255), cv::Scalar(255, 128, 0)};
  const cv::Scalar red(0, 0, 255);
  cv::Mat canvas = overlay_canvas(image);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const cv::Point start = on_canvas(segments[i].in_image.start);
    const cv::Point end = on_canvas(segments[i].in_image.end);
    const int radius = kDotRadius * (1 << kCanvasFractionBits);
    cv::line(canvas, start, end, colours[i % colours.size()], 1, cv::LINE_AA, kCanvasFractionBits);
    cv::circle(canvas, start, radius, red, cv::FILLED, cv::LINE_AA, kCanvasFractionBits);
    cv::circle(canvas, end, radius, red, cv::FILLED, cv::LINE_AA, kCanvasFractionBits);
  }
  return canvas;
}

}  // namespace ridgeline::apps
