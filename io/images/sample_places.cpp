// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/sample_places.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr int kSampleBlock_px = 64;

/// The first pixel of block i of n in a row of blocks. It is a multiple of the block size, so that
/// a block lies within one tile of the file, whose sides are also multiples of that size.
int first_px_of_block(int i, int n, int size_px) {
  const int first = static_cast<int>((i + 0.5) / n * size_px) - kSampleBlock_px / 2;
  return std::max(0, first / kSampleBlock_px * kSampleBlock_px);
}

}  // namespace

std::vector<Window> sample_places(const cv::Size& size_px) {
  constexpr int kPerSide = 16;
  constexpr int kMaxPixels = kPerSide * kSampleBlock_px * kPerSide * kSampleBlock_px;
  const auto [width, height] = std::pair(size_px.width, size_px.height);
  if (std::int64_t{width} * height <= kMaxPixels) return {{0, 0, width, height}};
  const int n_columns = std::clamp(width / kSampleBlock_px, 1, kPerSide);
  const int n_rows = std::clamp(height / kSampleBlock_px, 1, kPerSide);
  std::vector<Window> places;
  for (int row = 0; row < n_rows; ++row) {
    for (int column = 0; column < n_columns; ++column) {
      places.push_back({first_px_of_block(column, n_columns, width),
                        first_px_of_block(row, n_rows, height), std::min(kSampleBlock_px, width),
                        std::min(kSampleBlock_px, height)});
    }
  }
  return places;
}

}  // namespace ridgeline::io
