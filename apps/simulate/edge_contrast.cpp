// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/edge_contrast.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::simulate {
namespace {

/// Value of a band in [0, 1], interpolated bilinearly; outside the window, the value of the nearest
/// pixel.
double sample(const ImageWindow& window, const Eigen::Vector2d& x_px, int band) {
  const cv::Mat& image = window.pixels;
  const auto at = [&](int column, int row) -> double {
    const int c = std::clamp(column - window.corner_px.x(), 0, image.cols - 1);
    const int r = std::clamp(row - window.corner_px.y(), 0, image.rows - 1);
    const std::size_t i = static_cast<std::size_t>(c) * image.channels() + band;
    return image.depth() == CV_8U ? image.ptr<std::uint8_t>(r)[i] / 255.0
                                  : image.ptr<std::uint16_t>(r)[i] / 65535.0;
  };
  const int column = static_cast<int>(std::floor(x_px.x()));
  const int row = static_cast<int>(std::floor(x_px.y()));
  const double s = x_px.x() - column;
  const double t = x_px.y() - row;
  return (1.0 - t) * ((1.0 - s) * at(column, row) + s * at(column + 1, row)) +
         t * ((1.0 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
}

}  // namespace

double contrast_across(const ImageWindow& window, const Segment2& segment_px) {
  constexpr double kBesidePx = 1.5;
  const Eigen::Vector2d side = kBesidePx * normal(segment_px);
  const int samples = 1 + static_cast<int>(length(segment_px));
  double largest = 0.0;
  for (int band = 0; band < window.pixels.channels(); ++band) {
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
      const Eigen::Vector2d x = point_at(segment_px, (i + 0.5) / samples);
      sum += sample(window, x + side, band) - sample(window, x - side, band);
    }
    largest = std::max(largest, std::abs(sum) / samples);
  }
  return largest;
}

}  // namespace ridgeline::simulate
