// SPDX-License-Identifier: BSD-3-Clause
#include "apps/match/match_overlay.h"

#include "apps/common/overlay_canvas.h"

#include <opencv2/imgproc.hpp>

#include <array>
#include <string>

namespace ridgeline::apps {
namespace {

const cv::Scalar kUnmatched(150, 150, 150);

/// Twelve hues around the circle; consecutive ones are far apart.
cv::Scalar colour_of(int number) {
  static constexpr std::array<std::array<int, 3>, 12> kColours{{{60, 60, 255},
                                                                {60, 255, 60},
                                                                {255, 120, 60},
                                                                {60, 255, 255},
                                                                {255, 60, 255},
                                                                {255, 255, 60},
                                                                {60, 160, 255},
                                                                {160, 255, 160},
                                                                {255, 60, 150},
                                                                {200, 200, 255},
                                                                {0, 200, 150},
                                                                {255, 200, 200}}};
  const auto& c = kColours[static_cast<std::size_t>(number) % kColours.size()];
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

void draw(cv::Mat& canvas, const EdgeSegment& segment, const cv::Scalar& colour, int width) {
  cv::line(canvas, on_canvas(segment.in_image.start), on_canvas(segment.in_image.end), colour,
           width, cv::LINE_AA, kCanvasFractionBits);
}

void label(cv::Mat& canvas, const EdgeSegment& segment, int number, const cv::Scalar& colour) {
  cv::putText(canvas, std::to_string(number),
              on_canvas(midpoint(segment.in_image)) / (1 << kCanvasFractionBits),
              cv::FONT_HERSHEY_SIMPLEX, 0.4, colour, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat match_overlay(const reconstruct::View& left,
                      const reconstruct::View& right,
                      std::span<const Correspondence> matches) {
  constexpr int kLabelled = 5;
  std::array<cv::Mat, 2> canvases{overlay_canvas(left.image), overlay_canvas(right.image)};
  for (const EdgeSegment& segment : left.segments) draw(canvases[0], segment, kUnmatched, 1);
  for (const EdgeSegment& segment : right.segments) draw(canvases[1], segment, kUnmatched, 1);
  for (const Correspondence& match : matches) {
    const cv::Scalar colour = colour_of(match.base);
    const EdgeSegment& a = left.segments[static_cast<std::size_t>(match.base)];
    const EdgeSegment& b = right.segments[static_cast<std::size_t>(match.other)];
    draw(canvases[0], a, colour, 2);
    draw(canvases[1], b, colour, 2);
    if (match.base % kLabelled != 0) continue;
    label(canvases[0], a, match.base, colour);
    label(canvases[1], b, match.base, colour);
  }
  const int rows = std::max(canvases[0].rows, canvases[1].rows);
  for (cv::Mat& canvas : canvases) {
    cv::copyMakeBorder(canvas, canvas, 0, rows - canvas.rows, 0, 0, cv::BORDER_CONSTANT);
  }
  cv::Mat both;
  cv::hconcat(canvases[0], canvases[1], both);
  return both;
}

}  // namespace ridgeline::apps
