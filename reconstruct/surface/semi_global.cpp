// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/semi_global.h"

#include "reconstruct/surface/cost_layout.h"
#include "reconstruct/surface/disparity_choice.h"
#include "reconstruct/surface/matching_cost.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

/// Cost of a disparity outside the range of the previous pixel. It exceeds all other costs, even
/// with a penalty added.
constexpr std::int16_t kNever = 16000;

/// Penalties for a change of disparity along a path, by one pixel and by more.
struct Penalties {
  std::int16_t small, large;
};

/// The penalties recommended by OpenCV for a block.
Penalties penalties_of(const cv::Mat& view) {
  const int block = view.channels() * MatchingCost::kBlock_px * MatchingCost::kBlock_px;
  return {static_cast<std::int16_t>(8 * block), static_cast<std::int16_t>(32 * block)};
}

/// Upper limit of the costs of a pixel, so that the sum over eight paths fits into 16 bits; a path
/// costs at most the large penalty more than a pixel.
std::int16_t most_cost(const Penalties& penalties) {
  constexpr int kMaxPathCost = std::numeric_limits<std::uint16_t>::max() / 8;
  return static_cast<std::int16_t>(kMaxPathCost - penalties.large);
}

/// The costs of the paths of one direction at the pixels of a row, and the minimum for each pixel.
struct PathRow {
  std::vector<std::int16_t> costs, least;
};

/// The cost of a path up to a pixel.
struct PathCost {
  const std::int16_t* costs;  ///< including one disparity below and one above the range
  std::int16_t least;
};

/// Follows a path to the next pixel (Eq. 13 of Hirschmueller 2008), adds its costs there to the
/// sums over all paths, and returns the minimum of these costs.
std::int16_t follow(const PathCost& before,
                    const std::int16_t* __restrict matching,
                    int n,
                    const Penalties& penalties,
                    std::int16_t* __restrict costs,
                    std::uint16_t* __restrict sums) {
  const std::int16_t* __restrict from = before.costs;
  const std::int16_t least_before = before.least;
  const std::int16_t small = penalties.small;
  const auto jump = static_cast<std::int16_t>(least_before + penalties.large);
  std::int16_t least = kNever;
  for (int k = 0; k < n; ++k) {
    const auto beside = static_cast<std::int16_t>(std::min(from[k - 1], from[k + 1]) + small);
    const std::int16_t cheapest = std::min(std::min(from[k], beside), jump);
    costs[k] = static_cast<std::int16_t>(matching[k] + cheapest - least_before);
    least = std::min(least, costs[k]);
    sums[k] = static_cast<std::uint16_t>(sums[k] + costs[k]);
  }
  return least;
}

class SemiGlobal {
 public:
  SemiGlobal(const cv::Mat& left, const cv::Mat& right, const DisparityRanges& ranges)
      : ranges_(ranges),
        layout_(ranges),
        penalties_(penalties_of(left)),
        matching_(layout_.size()),
        sums_(layout_.size()),
        in_other_range_(static_cast<std::size_t>(ranges.n_all) + 2),
        at_start_(static_cast<std::size_t>(ranges.n_all) + 2) {
    find_matching_costs(MatchingCost(left, right, most_cost(penalties_)));
  }

  [[nodiscard]] cv::Mat disparities() {
    cv::Mat disparities_px(ranges_.size_px, CV_32F);
    DisparityChoice choice(ranges_);
    follow_four_paths(1, [](int) {});
    follow_four_paths(-1, [&](int y) {
      choice.of_row(y, sums_.data() + layout_.at(0, y), disparities_px.ptr<float>(y));
    });
    return disparities_px;
  }

 private:
  void find_matching_costs(const MatchingCost& cost) {
    constexpr int kCell = DisparityRanges::kCell_px;
    const cv::Rect whole(cv::Point(), ranges_.size_px);
    std::vector<std::int16_t*> rows;
    for (int y = 0; y < whole.height; y += kCell) {
      for (int x = 0; x < whole.width; x += kCell) {
        if (ranges_.at(x, y).n == 0) continue;
        const cv::Rect cell = cv::Rect(x, y, kCell, kCell) & whole;
        rows.clear();
        for (int row = y; row < y + cell.height; ++row)
          rows.push_back(&matching_[layout_.at(x, row)]);
        cost.of_cell(cell, ranges_.at(x, y), rows);
      }
    }
  }

  /// Follows the paths of four directions through all pixels, from the upper left (sign = 1) or
  /// from the lower right (sign = -1), and calls `row_done` for every finished row.
  template <typename RowDone>
  void follow_four_paths(int sign, const RowDone& row_done) {
    const std::array<cv::Point, 4> steps{{{sign, 0}, {sign, sign}, {0, sign}, {-sign, sign}}};
    std::array<PathRow, 4> now;
    for (PathRow& row : now) {
      row.costs.resize(layout_.padded_row_size());
      row.least.resize(static_cast<std::size_t>(ranges_.size_px.width));
    }
    std::array<PathRow, 4> before = now;
    for (int i = 0; i < ranges_.size_px.height; ++i) {
      const int y = sign > 0 ? i : ranges_.size_px.height - 1 - i;
      std::swap(now, before);
      for (std::size_t path = 0; path < steps.size(); ++path)
        follow_row(y, sign, steps[path], steps[path].y == 0 ? now[path] : before[path], now[path]);
      row_done(y);
    }
  }

  /// @param before  the row from which the step comes; the same row for steps along it
  void follow_row(int y, int sign, const cv::Point& step, const PathRow& before, PathRow& now) {
    for (int i = 0; i < ranges_.size_px.width; ++i) {
      const int x = sign > 0 ? i : ranges_.size_px.width - 1 - i;
      const DisparityRange& range = ranges_.at(x, y);
      if (range.n == 0) continue;
      const std::size_t at = layout_.at(x, y);
      std::int16_t* costs = &now.costs[layout_.in_padded_row(x, y)];
      now.least[static_cast<std::size_t>(x)] =
          follow(cost_before(range, cv::Point(x, y) - step, before), &matching_[at], range.n,
                 penalties_, costs, &sums_[at]);
      costs[-1] = costs[range.n] = kNever;
    }
  }

  /// The cost of a path up to the pixel `from`, for the disparities of a range.
  PathCost cost_before(const DisparityRange& range, const cv::Point& from, const PathRow& row) {
    const bool starts =
        !cv::Rect(cv::Point(), ranges_.size_px).contains(from) || ranges_.at(from.x, from.y).n == 0;
    if (starts) return {&at_start_[1], 0};
    const DisparityRange& other = ranges_.at(from.x, from.y);
    const std::int16_t* costs = &row.costs[layout_.in_padded_row(from.x, from.y)];
    return {range == other ? costs : in_other_range(range, other, costs),
            row.least[static_cast<std::size_t>(from.x)]};
  }

  const std::int16_t* in_other_range(const DisparityRange& wanted,
                                     const DisparityRange& range,
                                     const std::int16_t* costs) {
    const int start = wanted.first - 1;
    const int end = wanted.first + wanted.n + 1;
    std::fill_n(in_other_range_.begin(), end - start, kNever);
    const int first = std::max(start, range.first);
    const int last = std::min(end, range.first + range.n);
    if (first < last) {
      std::copy_n(costs + (first - range.first), last - first,
                  in_other_range_.begin() + (first - start));
    }
    return &in_other_range_[1];
  }

  const DisparityRanges& ranges_;
  CostLayout layout_;
  Penalties penalties_;
  std::vector<std::int16_t> matching_;  ///< matching costs of the pixels
  std::vector<std::uint16_t> sums_;     ///< sums of the costs of their paths
  std::vector<std::int16_t> in_other_range_;
  std::vector<std::int16_t> at_start_;  ///< the costs before the first pixel of a path, zero
};

}  // namespace

cv::Mat semi_global_disparities(const cv::Mat& left,
                                const cv::Mat& right,
                                const DisparityRanges& ranges) {
  constexpr int kMedian_px = 3;
  cv::Mat result;
  cv::medianBlur(SemiGlobal(left, right, ranges).disparities(), result, kMedian_px);
  return result;
}

}  // namespace ridgeline::reconstruct
