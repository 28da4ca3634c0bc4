// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <array>

namespace ridgeline::reconstruct {

inline constexpr int kMaxBands = 4;
using Colour = std::array<float, kMaxBands>;  ///< per band; 0 where the image has fewer

/// Bilinear interpolation in a CV_32FC(1..4) image.
class ImageSampler {
 public:
  explicit ImageSampler(const cv::Mat& image) : image_(&image), n_bands_(image.channels()) {}

  [[nodiscard]] int n_bands() const { return n_bands_; }

  /// Returns false and leaves `colour` unchanged if x lies outside the rectangle through the
  /// centres of the border pixels.
  [[nodiscard]] bool sample(const Eigen::Vector2d& x, Colour& colour) const {
    if (!(x.x() >= 0.0 && x.y() >= 0.0 && x.x() <= image_->cols - 1.0 &&
          x.y() <= image_->rows - 1.0)) {
      return false;
    }
    const int column = std::min(static_cast<int>(x.x()), image_->cols - 2);
    const int row = std::min(static_cast<int>(x.y()), image_->rows - 2);
    const auto fx = static_cast<float>(x.x() - column);
    const auto fy = static_cast<float>(x.y() - row);
    const float* upper = image_->ptr<float>(row) + static_cast<std::ptrdiff_t>(column) * n_bands_;
    const float* lower =
        image_->ptr<float>(row + 1) + static_cast<std::ptrdiff_t>(column) * n_bands_;
    switch (n_bands_) {
      case 1:
        blend<1>(upper, lower, fx, fy, colour);
        break;
      case 2:
        blend<2>(upper, lower, fx, fy, colour);
        break;
      case 3:
        blend<3>(upper, lower, fx, fy, colour);
        break;
      default:
        blend<4>(upper, lower, fx, fy, colour);
    }
    return true;
  }

 private:
  /// The number of bands is a template parameter so that the compiler can unroll this innermost
  /// loop of the matching.
  template <int kBands>
  static void blend(const float* upper, const float* lower, float fx, float fy, Colour& colour) {
    for (int band = 0; band < kBands; ++band) {
      const float top = upper[band] + fx * (upper[band + kBands] - upper[band]);
      const float bottom = lower[band] + fx * (lower[band + kBands] - lower[band]);
      colour[band] = top + fy * (bottom - top);
    }
  }

  const cv::Mat* image_;
  int n_bands_;
};

}  // namespace ridgeline::reconstruct
