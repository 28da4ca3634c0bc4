// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {

/// Chooses the disparity with the lowest cost for each pixel, if it is unique and passes the check
/// from right to left. It keeps a reference to the ranges.
class DisparityChoice {
 public:
  explicit DisparityChoice(const DisparityRanges& ranges);

  /// Chooses the disparities of a row.
  /// @param costs           the costs of the ranges of its pixels, one pixel after the other
  /// @param disparities_px  output, one value for each pixel of the row; negative if none chosen.
  ///                        Subpixel values come from a parabola through three costs. An end of a
  ///                        range is chosen only if it is 0 or n_all - 1, because lower costs may
  ///                        lie beyond it.
  void of_row(int y, const std::uint16_t* costs, float* disparities_px);

 private:
  float of_pixel(int x, const DisparityRange& range, const std::uint16_t* costs);
  [[nodiscard]] bool contradicts(int x, int disparity_px) const;

  const DisparityRanges& ranges_;
  /// For each column of the right view, the best disparity (or -1) of the pixels of the left view
  /// that are matched to it, and its cost.
  std::vector<int> best_of_right_, least_of_right_;
};

}  // namespace ridgeline::reconstruct
