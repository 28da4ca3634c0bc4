// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// How strong the gradient of an image is where there is no edge. This is noise of the sensor,
/// which is less in shadows, and texture. It is estimated by the median strength in blocks, scaled
/// to the sigma of one component and interpolated between the middles of the blocks. Edges disturb
/// the median little, because they fill less than half of a block.
class NoiseGrid {
 public:
  static constexpr int kBlock_px = 64;

  /// `gradient`: CV_32FC2. No value is less than `lowest`, which stands for the steps of the grey
  /// values in flat parts. `corner_px`: the place of the first pixel in the frame that the image is
  /// cut from; blocks begin at the corner of the frame, so that two windows of one frame have the
  /// same blocks.
  NoiseGrid(const cv::Mat& gradient, float lowest, const cv::Point& corner_px = {});

  /// The strength at a pixel of the image; it is constant beyond the middles of the outer blocks.
  [[nodiscard]] float at(int x, int y) const;

  /// The strengths at the pixels of `area`, CV_32FC1.
  [[nodiscard]] cv::Mat in(const cv::Rect& area) const;

 private:
  cv::Mat blocks_;      ///< CV_32FC1
  cv::Point in_block_;  ///< the place of the first pixel in its block
};

}  // namespace ridgeline::reconstruct
