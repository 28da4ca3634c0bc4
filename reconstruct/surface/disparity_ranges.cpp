// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/disparity_ranges.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Initial and maximum width of the margin around a cell in which coarse disparities are used. The
/// margin is needed because they locate a step only to a few pixels.
constexpr int kBeside_px = 4;
constexpr int kMaxBeside_px = 64;
/// Number of disparities searched below and above those of the coarse image.
constexpr int kGap_px = 4;
constexpr int kMaxCellDisparities = 256;

DisparityRanges without_ranges(const cv::Size& size_px, int n_all) {
  constexpr int kCell = DisparityRanges::kCell_px;
  const auto n_cells = [](int length_px) { return (length_px + kCell - 1) / kCell; };
  DisparityRanges ranges{size_px, n_all, {n_cells(size_px.width), n_cells(size_px.height)}, {}};
  ranges.of_cells.resize(static_cast<std::size_t>(ranges.cells.area()));
  return ranges;
}

/// Number and range of the known disparities in a part of an image.
struct Known {
  int n = 0;
  float least_px = HUGE_VALF, most_px = -HUGE_VALF;
};

Known known_in(const cv::Mat& disparities_px) {
  Known known;
  for (int y = 0; y < disparities_px.rows; ++y) {
    const auto* row = disparities_px.ptr<float>(y);
    for (int x = 0; x < disparities_px.cols; ++x) {
      if (row[x] < 0.0F) continue;
      ++known.n;
      known.least_px = std::min(known.least_px, row[x]);
      known.most_px = std::max(known.most_px, row[x]);
    }
  }
  return known;
}

DisparityRange range_around(const Known& coarse, int n_all) {
  constexpr int kStep = DisparityRange::kStep;
  const int low = std::max(0, 2 * static_cast<int>(std::floor(coarse.least_px)) - kGap_px);
  const int high = std::min(n_all, 2 * static_cast<int>(std::ceil(coarse.most_px)) + kGap_px + 1);
  const int n = (high - low + kStep - 1) / kStep * kStep;
  if (n > kMaxCellDisparities) return {};
  return {std::min(low, n_all - n), n};
}

DisparityRange range_of_cell(const cv::Mat& coarse_px, const cv::Point& cell, int n_all) {
  constexpr int kCell_px = DisparityRanges::kCell_px / 2;
  const cv::Rect whole(cv::Point(), coarse_px.size());
  for (int beside = kBeside_px; beside <= kMaxBeside_px; beside *= 2) {
    const int side = kCell_px + 2 * beside;
    const cv::Rect around =
        cv::Rect(cell * kCell_px - cv::Point(beside, beside), cv::Size(side, side)) & whole;
    const Known known = known_in(coarse_px(around));
    if (known.n > 0 && 2 * known.n >= around.area()) return range_around(known, n_all);
  }
  return {};
}

}  // namespace

DisparityRanges all_disparities(const cv::Size& size_px, int n_all) {
  DisparityRanges ranges = without_ranges(size_px, n_all);
  std::ranges::fill(ranges.of_cells, DisparityRange{0, n_all});
  return ranges;
}

DisparityRanges disparities_near(const cv::Mat& coarse_px, const cv::Size& size_px, int n_all) {
  DisparityRanges ranges = without_ranges(size_px, n_all);
  auto range = ranges.of_cells.begin();
  for (int row = 0; row < ranges.cells.height; ++row) {
    for (int column = 0; column < ranges.cells.width; ++column)
      *range++ = range_of_cell(coarse_px, {column, row}, n_all);
  }
  return ranges;
}

}  // namespace ridgeline::reconstruct
