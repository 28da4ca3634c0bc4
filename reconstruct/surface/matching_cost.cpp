// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/matching_cost.h"

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace ridgeline::reconstruct {
namespace {

constexpr int kLanes = cv::v_uint8x16::nlanes;
constexpr int kMaxMatchedBands = 3;
constexpr std::int16_t kMaxGradient = 63;
/// Grey values have a weight of a quarter, because the illumination differs between the views.
constexpr int kGreyShift = 2;

/// Writes the gradients of a row, clipped and shifted to the range from 0 to twice their bound.
void bounded_gradients(const std::int16_t* gradient, int n, std::uint8_t* bounded) {
  for (int x = 0; x < n; ++x) {
    const auto within =
        std::max<std::int16_t>(-kMaxGradient, std::min<std::int16_t>(kMaxGradient, gradient[x]));
    bounded[x] = static_cast<std::uint8_t>(within + kMaxGradient);
  }
}

/// The minimum and maximum within half a pixel of each pixel of a row.
void bounds_of(const std::uint8_t* __restrict value,
               int n,
               std::uint8_t* __restrict low,
               std::uint8_t* __restrict high) {
  low[0] = high[0] = value[0];
  for (int x = 1; x < n; ++x) {
    const auto between = static_cast<std::uint8_t>((value[x - 1] + value[x]) / 2);
    low[x] = std::min(between, value[x]);
    high[x] = std::max(between, value[x]);
  }
  for (int x = 0; x < n - 1; ++x) {
    const auto between = static_cast<std::uint8_t>((value[x] + value[x + 1]) / 2);
    low[x] = std::min(between, low[x]);
    high[x] = std::max(between, high[x]);
  }
}

/// 16 pixels of a plane, or one pixel repeated 16 times.
struct Pixels {
  cv::v_uint8x16 value, low, high;
};

/// Distance of each value from the other one's bounds, the smaller of the two. Differences of such
/// vectors saturate at 0.
cv::v_uint8x16 differences(const Pixels& left, const Pixels& right) {
  return cv::v_min(cv::v_max(left.value - right.high, right.low - left.value),
                   cv::v_max(right.value - left.high, left.low - right.value));
}

/// Adds up five runs of n values whose starts are `stride` apart.
void add_five(const std::int16_t* __restrict values,
              std::size_t stride,
              std::size_t n,
              std::int16_t most,
              std::int16_t* __restrict sums) {
  for (std::size_t k = 0; k < n; ++k) {
    const auto sum =
        static_cast<std::int16_t>(values[k] + values[k + stride] + values[k + 2 * stride] +
                                  values[k + 3 * stride] + values[k + 4 * stride]);
    sums[k] = std::min(most, sum);
  }
}

constexpr int kHalf_px = MatchingCost::kBlock_px / 2;  // of a block
static_assert(MatchingCost::kBlock_px == 5, "add_five() sums a block");

}  // namespace

MatchingCost::MatchingCost(const cv::Mat& left, const cv::Mat& right, std::int16_t most)
    : size_(left.size()),
      n_bands_(left.channels()),
      right_width_(right.cols),
      most_(most),
      left_(planes_of(left, false)),
      right_(planes_of(right, true)) {}

MatchingCost::Planes MatchingCost::planes_of(const cv::Mat& view, bool from_right_to_left) {
  const int n_bands = view.channels();
  Planes planes;
  // The planes are padded because the last costs of a pixel are computed for a full set of lanes.
  for (cv::Mat* plane : {&planes.value, &planes.low, &planes.high})
    plane->create(view.rows, 2 * n_bands * view.cols + kLanes, CV_8U);
  cv::Mat grey;
  cv::Mat gradient;
  for (int band = 0; band < n_bands; ++band) {
    cv::extractChannel(view, grey, band);
    cv::Sobel(grey, gradient, CV_16S, 1, 0, 3, 1.0, 0.0, cv::BORDER_REPLICATE);
    for (int y = 0; y < view.rows; ++y) {
      const int gradients = band * view.cols;
      const int greys = (n_bands + band) * view.cols;
      bounded_gradients(gradient.ptr<std::int16_t>(y), view.cols,
                        &planes.value.at<std::uint8_t>(y, gradients));
      std::copy_n(grey.ptr(y), view.cols, &planes.value.at<std::uint8_t>(y, greys));
      for (const int start : {gradients, greys}) {
        std::uint8_t* value = &planes.value.at<std::uint8_t>(y, start);
        if (from_right_to_left) std::reverse(value, value + view.cols);
        bounds_of(value, view.cols, &planes.low.at<std::uint8_t>(y, start),
                  &planes.high.at<std::uint8_t>(y, start));
      }
    }
  }
  return planes;
}

void MatchingCost::of_pixel(int x, int y, const DisparityRange& range, std::int16_t* costs) const {
  constexpr int kHalfOfLanes = kLanes / 2;
  static_assert(DisparityRange::kStep % kHalfOfLanes == 0);
  const int n_planes = 2 * n_bands_;
  std::array<Pixels, std::size_t{2} * kMaxMatchedBands> left;
  for (int plane = 0; plane < n_planes; ++plane) {
    const int at = plane * size_.width + x;
    left[static_cast<std::size_t>(plane)] = {cv::v_setall_u8(left_.value.ptr(y)[at]),
                                             cv::v_setall_u8(left_.low.ptr(y)[at]),
                                             cv::v_setall_u8(left_.high.ptr(y)[at])};
  }
  for (int k = 0; k < range.n; k += kLanes) {
    std::array<cv::v_uint16x8, 2> sums{cv::v_setzero_u16(), cv::v_setzero_u16()};
    for (int plane = 0; plane < n_planes; ++plane) {
      const int at = plane * right_width_ + size_.width - 1 - x + range.first + k;
      const Pixels right{cv::v_load(right_.value.ptr(y) + at), cv::v_load(right_.low.ptr(y) + at),
                         cv::v_load(right_.high.ptr(y) + at)};
      std::array<cv::v_uint16x8, 2> wide;
      cv::v_expand(differences(left[static_cast<std::size_t>(plane)], right), wide[0], wide[1]);
      const int shift = plane < n_bands_ ? 0 : kGreyShift;
      sums[0] += wide[0] >> shift;
      sums[1] += wide[1] >> shift;
    }
    cv::v_store(costs + k, cv::v_reinterpret_as_s16(sums[0]));
    if (k + kHalfOfLanes < range.n)
      cv::v_store(costs + k + kHalfOfLanes, cv::v_reinterpret_as_s16(sums[1]));
  }
}

void MatchingCost::of_row(int y,
                          const cv::Rect& cell,
                          const DisparityRange& range,
                          std::vector<std::int16_t>& pixels,
                          std::int16_t* sums) const {
  const auto n = static_cast<std::size_t>(range.n);
  for (int i = 0; i < cell.width + 2 * kHalf_px; ++i) {
    const int x = std::clamp(cell.x + i - kHalf_px, 0, size_.width - 1);
    of_pixel(x, y, range, &pixels[static_cast<std::size_t>(i) * n]);
  }
  add_five(pixels.data(), n, static_cast<std::size_t>(cell.width) * n, INT16_MAX, sums);
}

void MatchingCost::of_cell(const cv::Rect& cell,
                           const DisparityRange& range,
                           std::span<std::int16_t* const> rows) const {
  const auto n = static_cast<std::size_t>(range.n);
  const std::size_t row_length = static_cast<std::size_t>(cell.width) * n;
  const int n_rows = cell.height + 2 * kHalf_px;
  std::vector<std::int16_t> pixels(row_length + (MatchingCost::kBlock_px - 1) * n);
  std::vector<std::int16_t> sums(static_cast<std::size_t>(n_rows) * row_length);
  for (int j = 0; j < n_rows; ++j) {
    const int y = std::clamp(cell.y + j - kHalf_px, 0, size_.height - 1);
    of_row(y, cell, range, pixels, &sums[static_cast<std::size_t>(j) * row_length]);
  }
  for (std::size_t j = 0; j < rows.size(); ++j)
    add_five(&sums[j * row_length], row_length, row_length, most_, rows[j]);
}

}  // namespace ridgeline::reconstruct
