// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {

/// Chooses the disparity of each pixel that costs least, if it is the only one and holds from right
/// to left. It refers to the ranges.
class DisparityChoice {
 public:
  explicit DisparityChoice(const DisparityRanges& ranges);

  /// Chooses the disparities of a row.
  /// @param costs           those of the ranges of its pixels, one pixel after the other
  /// @param disparities_px  as many as the row has pixels; negative if nothing is chosen. To a part
  /// of a pixel by a
  ///                        parabola through three costs. An end of a range is not chosen, as what
  ///                        lies beyond may cost less, unless it is 0 or n_all - 1.
  void of_row(int y, const std::uint16_t* costs, float* disparities_px);

 private:
  float of_pixel(int x, const DisparityRange& range, const std::uint16_t* costs);
  [[nodiscard]] bool contradicts(int x, int disparity_px) const;

  const DisparityRanges& ranges_;
  /// For each column of the right view the best disparity of the pixels of the left view that see
  /// it, or -1, and its cost.
  std::vector<int> best_of_right_, least_of_right_;
};

}  // namespace ridgeline::reconstruct
