// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "tests/support/random.h"

#include <opencv2/core.hpp>

#include <array>
#include <cmath>

namespace ridgeline::test {

/// A strip of one colour between two others, seen through a Gaussian point spread: its borders are
/// lines through the image, offset from the row `row_px` of a slightly inclined base line.
struct BlurredStrip {
  double row_px = 40.3;
  double slope = 0.11;                            ///< slope of the base line, px per px
  std::array<double, 2> offsets_px{-0.75, 0.75};  ///< offsets of the borders along the normal
  std::array<double, 2> tilts_px{0.0, 0.0};  ///< at the end of base_segment(), minus at its start
  double blur_px = 0.55;
  double noise = 0.0;
  std::array<cv::Vec3d, 3> colours{{{0.2, 0.3, 0.2}, {0.6, 0.5, 0.55}, {0.35, 0.4, 0.7}}};

  static constexpr int kWidth_px = 120;
  static constexpr int kHeight_px = 80;

  [[nodiscard]] Segment2 base_segment() const {
    return {{10.0, row_px + 10.0 * slope}, {110.0, row_px + 110.0 * slope}};
  }

  /// The strip as an image, CV_32FC3.
  [[nodiscard]] cv::Mat image() const {
    const Segment2 base = base_segment();
    const double len = length(base);
    const Eigen::Vector2d along = (base.end - base.start) / len;
    const Eigen::Vector2d normal(-along.y(), along.x());
    Random random(1);
    cv::Mat image(kHeight_px, kWidth_px, CV_32FC3);
    for (int y = 0; y < kHeight_px; ++y) {
      for (int x = 0; x < kWidth_px; ++x) {
        const Eigen::Vector2d d = Eigen::Vector2d(x, y) - base.start;
        const double tau = 2.0 * along.dot(d) / len - 1.0;
        cv::Vec3d colour = colours[0];
        for (std::size_t i = 0; i < 2; ++i) {
          const double z = (normal.dot(d) - offsets_px[i] - tau * tilts_px[i]) / blur_px;
          colour += 0.5 * std::erfc(-z * M_SQRT1_2) * (colours[i + 1] - colours[i]);
        }
        for (int band = 0; band < 3; ++band) {
          image.at<cv::Vec3f>(y, x)[band] = static_cast<float>(colour[band] + random.normal(noise));
        }
      }
    }
    return image;
  }
};

}  // namespace ridgeline::test
