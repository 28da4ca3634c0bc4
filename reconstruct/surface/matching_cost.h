// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// How unlike the pixels of two rectified views are: absolute differences of the gradient along the
/// rows and, a quarter of them, of the grey values, in all bands and over 5 x 5 pixels. They do not
/// depend on where pixels sample an edge (Birchfield and Tomasi 1998). The same costs as those of
/// cv::StereoSGBM.
class MatchingCost {
 public:
  static constexpr int kBlock_px = 5;

  /// @param left   CV_8UC1 or CV_8UC3
  /// @param right  the same rows and bands, `n_all` columns wider: column x of the left view and
  /// disparity d belong
  ///               to its column x + n_all - d
  /// @param most   larger costs become this one
  MatchingCost(const cv::Mat& left, const cv::Mat& right, std::int16_t most);

  /// Writes the costs of a cell. Outside of the view its border counts on.
  /// @param range  within [0, n_all)
  /// @param rows   where the costs of each row of the cell are written, pixel by pixel, `range.n`
  /// each
  void of_cell(const cv::Rect& cell,
               const DisparityRange& range,
               std::span<std::int16_t* const> rows) const;

 private:
  /// The gradients of all bands and then the grey values of all bands, one after the other in each
  /// row: the values themselves, and the least and the largest within half a pixel.
  struct Planes {
    cv::Mat value, low, high;
  };
  static Planes planes_of(const cv::Mat& view, bool from_right_to_left);

  void of_pixel(int x, int y, const DisparityRange& range, std::int16_t* costs) const;
  /// Sums over the columns of a block at the pixels of a cell's row.
  void of_row(int y,
              const cv::Rect& cell,
              const DisparityRange& range,
              std::vector<std::int16_t>& pixels,
              std::int16_t* sums) const;

  cv::Size size_;
  int n_bands_, right_width_;
  std::int16_t most_;
  Planes left_, right_;  ///< the right ones run from right to left, as disparities do
};

}  // namespace ridgeline::reconstruct
