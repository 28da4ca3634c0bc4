// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// How strong the gradient of an image is where there is no edge: noise of the sensor, which is
/// less in shadows, and texture. The median strength in blocks, which edges disturb little as they
/// fill less than half of a block, scaled to the sigma of one component and interpolated between
/// the middles of the blocks.
class NoiseGrid {
 public:
  static constexpr int kBlock_px = 64;

  /// `gradient`: CV_32FC2. No value is less than `lowest`, which stands for the steps of the grey
  /// values in flat parts.
  NoiseGrid(const cv::Mat& gradient, float lowest);

  /// At a pixel of the image; constant beyond the middles of the outer blocks.
  [[nodiscard]] float at(int x, int y) const;

  /// The values of `area`, CV_32FC1.
  [[nodiscard]] cv::Mat in(const cv::Rect& area) const;

 private:
  cv::Mat blocks_;  ///< CV_32FC1
};

}  // namespace ridgeline::reconstruct
