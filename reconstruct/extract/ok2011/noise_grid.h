// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// The strength of the gradient of an image away from edges. It is caused by sensor noise, which is
/// lower in shadows, and by texture. It is estimated by the median strength in blocks, scaled to
/// the sigma of one component and interpolated between the centres of the blocks. Edges hardly
/// affect the median, because they fill less than half of a block.
class NoiseGrid {
 public:
  static constexpr int kBlock_px = 64;

  /// `gradient`: CV_32FC2. No value is below `lowest`, which represents the quantisation of the
  /// grey values in flat areas. `corner_px`: the position of the first pixel in the frame from
  /// which the image is cut; blocks begin at the corner of the frame, so that two windows of one
  /// frame have the same blocks. `has_data`: ImagePart::has_data; blocks without data have the
  /// median of all others.
  NoiseGrid(const cv::Mat& gradient,
            float lowest,
            const cv::Point& corner_px = {},
            const cv::Mat& has_data = {});

  /// The strength at a pixel of the image; it is constant beyond the centres of the outer blocks.
  [[nodiscard]] float at(int x, int y) const;

  /// The strengths at the pixels of `area`, CV_32FC1.
  [[nodiscard]] cv::Mat in(const cv::Rect& area) const;

 private:
  cv::Mat blocks_;      ///< CV_32FC1
  cv::Point in_block_;  ///< position of the first pixel in its block
};

}  // namespace ridgeline::reconstruct
