// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <vector>

namespace ridgeline::reconstruct {

/// Disparities [first, first + n) that are searched. n is a multiple of kStep.
struct DisparityRange {
  static constexpr int kStep = 8;  ///< so that the costs of a pixel fill SIMD vectors

  int first = 0, n = 0;

  [[nodiscard]] bool operator==(const DisparityRange&) const = default;
};

/// The disparities that are searched in each cell of an image. Nothing is searched in a cell whose
/// n is 0.
struct DisparityRanges {
  static constexpr int kCell_px = 16;

  cv::Size size_px;                      ///< of the image
  int n_all = 0;                         ///< all ranges lie in [0, n_all)
  cv::Size cells;                        ///< number of cells along a row and a column
  std::vector<DisparityRange> of_cells;  ///< row by row

  /// The cell of a pixel.
  [[nodiscard]] std::size_t cell_at(int x, int y) const {
    const int cell = y / kCell_px * cells.width + x / kCell_px;
    return static_cast<std::size_t>(cell);
  }
  [[nodiscard]] const DisparityRange& at(int x, int y) const { return of_cells[cell_at(x, y)]; }
};

/// All of [0, n_all) in every cell.
/// @param n_all  a multiple of DisparityRange::kStep
DisparityRanges all_disparities(const cv::Size& size_px, int n_all);

/// The disparities around those of an image of half the size. If fewer than half of the coarse
/// disparities around a cell are known, a wider neighbourhood is used. Nothing is searched if too
/// few are known there either, or if the known ones span more than 256 disparities, which limits
/// the memory.
/// @param coarse_px  CV_32F, disparities in coarse pixels, negative where they are not known
/// @param size_px    size of the image; if it is odd, the coarse image does not cover the last row
///                   or column
/// @param n_all      a multiple of DisparityRange::kStep
DisparityRanges disparities_near(const cv::Mat& coarse_px, const cv::Size& size_px, int n_all);

}  // namespace ridgeline::reconstruct
