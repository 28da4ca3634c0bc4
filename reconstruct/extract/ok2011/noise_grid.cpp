// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/noise_grid.h"

#include "reconstruct/geometry/median.h"

#include <opencv2/core.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace ridgeline::reconstruct {
namespace {

/// Median of a Rayleigh distribution with sigma 1.
constexpr float kRayleighMedian = 1.1774F;

constexpr float kUnknown = -1.0F;

/// The median strength of the pixels with data; kUnknown if there are none.
float median_strength(const cv::Mat& gradient, const cv::Mat& has_data) {
  std::vector<float> squares;
  squares.reserve(gradient.total());
  for (int y = 0; y < gradient.rows; ++y) {
    const auto* row = gradient.ptr<cv::Vec2f>(y);
    for (int x = 0; x < gradient.cols; ++x) {
      if (has_data.empty() || has_data.at<std::uint8_t>(y, x) != 0)
        squares.push_back(row[x].dot(row[x]));
    }
  }
  return squares.empty() ? kUnknown : std::sqrt(upper_median(std::move(squares)));
}

void fill_unknown(float lowest, cv::Mat& blocks) {
  std::vector<float> known;
  std::ranges::copy_if(cv::Mat_<float>(blocks), std::back_inserter(known),
                       [](float noise) { return noise != kUnknown; });
  if (known.size() == blocks.total()) return;
  blocks.setTo(known.empty() ? lowest : upper_median(std::move(known)), blocks == kUnknown);
}

/// The block whose centre is before a pixel, the next block, and the weight of the next block.
struct GridPosition {
  int first, second;
  float share;
};

GridPosition position(int x, int n_blocks) {
  const float u = (static_cast<float>(x) + 0.5F) / NoiseGrid::kBlock_px - 0.5F;
  const float inside = std::clamp(u, 0.0F, static_cast<float>(n_blocks - 1));
  const int first = static_cast<int>(inside);
  return {first, std::min(first + 1, n_blocks - 1), inside - static_cast<float>(first)};
}

int place_in_block(int x) {
  const int remainder = x % NoiseGrid::kBlock_px;
  return remainder < 0 ? remainder + NoiseGrid::kBlock_px : remainder;
}

float between(const cv::Mat& blocks, const GridPosition& column, const GridPosition& row) {
  const auto along_row = [&](int r) {
    const auto* values = blocks.ptr<float>(r);
    return values[column.first] + column.share * (values[column.second] - values[column.first]);
  };
  const float first = along_row(row.first);
  return first + row.share * (along_row(row.second) - first);
}

}  // namespace

NoiseGrid::NoiseGrid(const cv::Mat& gradient,
                     float lowest,
                     const cv::Point& corner_px,
                     const cv::Mat& has_data)
    : in_block_(place_in_block(corner_px.x), place_in_block(corner_px.y)) {
  const cv::Point end = in_block_ + cv::Point(gradient.size());
  blocks_.create((end.y + kBlock_px - 1) / kBlock_px, (end.x + kBlock_px - 1) / kBlock_px,
                 CV_32FC1);
  const cv::Rect whole({0, 0}, gradient.size());
  tbb::parallel_for(0, static_cast<int>(blocks_.total()), [&](int i) {
    const cv::Point block(i % blocks_.cols, i / blocks_.cols);
    const cv::Rect area(block * kBlock_px - in_block_, cv::Size(kBlock_px, kBlock_px));
    const cv::Rect seen = area & whole;
    const float strength =
        median_strength(gradient(seen), has_data.empty() ? has_data : has_data(seen));
    blocks_.at<float>(block) =
        strength == kUnknown ? kUnknown : std::max(lowest, strength / kRayleighMedian);
  });
  fill_unknown(lowest, blocks_);
}

float NoiseGrid::at(int x, int y) const {
  return between(blocks_, position(x + in_block_.x, blocks_.cols),
                 position(y + in_block_.y, blocks_.rows));
}

cv::Mat NoiseGrid::in(const cv::Rect& area) const {
  std::vector<GridPosition> columns;
  columns.reserve(static_cast<std::size_t>(area.width));
  for (int x = area.x; x < area.br().x; ++x)
    columns.push_back(position(x + in_block_.x, blocks_.cols));
  cv::Mat values(area.size(), CV_32FC1);
  for (int y = 0; y < area.height; ++y) {
    const GridPosition row = position(area.y + y + in_block_.y, blocks_.rows);
    auto* out = values.ptr<float>(y);
    for (int x = 0; x < area.width; ++x) out[x] = between(blocks_, columns[x], row);
  }
  return values;
}

}  // namespace ridgeline::reconstruct
