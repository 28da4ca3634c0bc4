// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The dissimilarity of pixels of two rectified views: absolute differences of the gradients along
/// the rows plus a quarter of those of the grey values, summed over all bands and 5 x 5 pixels. The
/// differences do not depend on where pixels sample an edge (Birchfield and Tomasi 1998). The costs
/// equal those of cv::StereoSGBM.
class MatchingCost {
 public:
  static constexpr int kBlock_px = 5;

  /// @param left   CV_8UC1 or CV_8UC3
  /// @param right  the same rows and bands, `n_all` columns wider; column x of the left view
  ///               corresponds to column x + n_all - d at disparity d
  /// @param most   upper limit of the costs
  MatchingCost(const cv::Mat& left, const cv::Mat& right, std::int16_t most);

  /// Writes the costs of a cell. Outside the view, the border pixels are replicated.
  /// @param range  within [0, n_all)
  /// @param rows   output arrays for the costs of the rows of the cell, `range.n` costs per pixel,
  ///               one pixel after the other
  void of_cell(const cv::Rect& cell,
               const DisparityRange& range,
               std::span<std::int16_t* const> rows) const;

 private:
  /// The gradients of all bands and then the grey values of all bands, one after the other in each
  /// row: the values themselves, and the minimum and maximum within half a pixel.
  struct Planes {
    cv::Mat value, low, high;
  };
  static Planes planes_of(const cv::Mat& view, bool from_right_to_left);

  void of_pixel(int x, int y, const DisparityRange& range, std::int16_t* costs) const;
  /// Sums of the costs over the columns of a block, for the pixels of a row of a cell.
  void of_row(int y,
              const cv::Rect& cell,
              const DisparityRange& range,
              std::vector<std::int16_t>& pixels,
              std::int16_t* sums) const;

  cv::Size size_;
  int n_bands_, right_width_;
  std::int16_t most_;
  Planes left_, right_;  ///< the right planes run from right to left, like the disparities
};

}  // namespace ridgeline::reconstruct
