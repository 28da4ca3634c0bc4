// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <string>
#include <vector>

namespace ridgeline::apps {

enum class LegendMark { kLine, kDashedLine, kPoints };

struct LegendEntry {
  LegendMark mark = LegendMark::kLine;
  std::vector<cv::Scalar> colours;  ///< blue, green, red; several for multicoloured points
  std::string text;                 ///< ASCII; OpenCV's fonts contain nothing else
};

/// The annotations around the picture of a figure.
struct FigureFrame {
  std::string title;  ///< ASCII
  std::vector<LegendEntry> legend{};
  double px_per_m = 0.0;  ///< scale of the picture; 0: no scale bar
  std::string
      scale_note{};  ///< text after the length of the bar if the scale varies within the picture
};

/// Returns the picture with the title above it and the legend and scale bar below it. CV_8UC3.
cv::Mat framed(const cv::Mat& picture, const FigureFrame& frame);

/// The length of a scale bar: the largest 1, 2 or 5 times a power of ten that is at most
/// `longest_m`.
double scale_bar_m(double longest_m);

}  // namespace ridgeline::apps
