// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/normalised_image.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/core.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ridgeline::reconstruct {
namespace {

using Histogram = std::vector<std::int64_t>;  ///< number of pixels per value

template <typename T>
std::vector<Histogram> histograms(const cv::Mat& raw) {
  const int n_bands = raw.channels();
  std::vector<Histogram> counts(n_bands, Histogram(std::size_t{1} << (8 * sizeof(T))));
  for (int y = 0; y < raw.rows; ++y) {
    const T* row = raw.ptr<T>(y);
    for (int x = 0; x < raw.cols; ++x) {
      for (int band = 0; band < n_bands; ++band) ++counts[band][row[x * n_bands + band]];
    }
  }
  return counts;
}

/// The smallest value such that at least `share` of the pixels do not exceed it.
double quantile(const Histogram& counts, double share, std::int64_t n_pixels) {
  const auto wanted = std::max<std::int64_t>(1, std::llround(share * double(n_pixels)));
  std::int64_t sum = 0;
  std::size_t value = 0;
  while ((sum += counts[value]) < wanted) ++value;
  return static_cast<double>(value);
}

/// The values that are mapped to 0 and 1; equal values for a band without any contrast.
std::array<double, 2> range_of(const Histogram& counts, std::int64_t n_pixels) {
  constexpr double kTail = 0.005;
  constexpr double kMargin = 0.25;
  const double lowest = quantile(counts, 0.0, n_pixels);
  const double highest = quantile(counts, 1.0, n_pixels);
  double low = quantile(counts, kTail, n_pixels);
  double high = quantile(counts, 1.0 - kTail, n_pixels);
  if (low == high) {  // nearly all pixels have the same value
    low = lowest;
    high = highest;
  }
  const double margin = kMargin * (high - low);
  return {std::max(lowest, low - margin), std::min(highest, high + margin)};
}

template <typename T>
BandRanges ranges_of_values(const cv::Mat& raw) {
  BandRanges ranges;
  for (const Histogram& counts : histograms<T>(raw))
    ranges.push_back(range_of(counts, static_cast<std::int64_t>(raw.total())));
  return ranges;
}

/// normalised = scale * raw + offset, then clipped.
struct LinearStretch {
  float scale = 0.0F;
  float offset = 0.0F;
};

LinearStretch linear(const std::array<double, 2>& range) {
  const auto [low, high] = range;
  if (high <= low) return {};
  return {static_cast<float>(1.0 / (high - low)), static_cast<float>(-low / (high - low))};
}

template <typename T>
cv::Mat stretched(const cv::Mat& raw, const BandRanges& ranges) {
  const int n_bands = raw.channels();
  std::array<LinearStretch, 4> of_band;
  std::ranges::transform(ranges, of_band.begin(), linear);
  cv::Mat image(raw.size(), CV_32FC(n_bands));
  tbb::parallel_for(tbb::blocked_range<int>(0, raw.rows), [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) {
      const T* in = raw.ptr<T>(y);
      auto* out = image.ptr<float>(y);
      for (int x = 0; x < raw.cols; ++x) {
        for (int band = 0; band < n_bands; ++band, ++in, ++out) {
          const float value = of_band[band].scale * static_cast<float>(*in) + of_band[band].offset;
          *out = std::clamp(value, 0.0F, 1.0F);
        }
      }
    }
  });
  return image;
}

void check_raw(const cv::Mat& raw) {
  check(!raw.empty(), "normalised_image: the image has no pixels");
  check(raw.channels() <= 4, "normalised_image: ", raw.channels(), " bands, must be 1 to 4");
  check(raw.depth() == CV_8U || raw.depth() == CV_16U, "normalised_image: depth code ", raw.depth(),
        ", must be 8 or 16 bit unsigned");
}

}  // namespace

BandRanges band_ranges(const cv::Mat& raw) {
  check_raw(raw);
  return raw.depth() == CV_8U ? ranges_of_values<std::uint8_t>(raw)
                              : ranges_of_values<std::uint16_t>(raw);
}

cv::Mat stretched_image(const cv::Mat& raw, const BandRanges& ranges) {
  check_raw(raw);
  check(static_cast<int>(ranges.size()) == raw.channels(), "stretched_image: ", ranges.size(),
        " ranges of values, must be one for each of ", raw.channels(), " bands");
  return raw.depth() == CV_8U ? stretched<std::uint8_t>(raw, ranges)
                              : stretched<std::uint16_t>(raw, ranges);
}

cv::Mat normalised_image(const cv::Mat& raw) { return stretched_image(raw, band_ranges(raw)); }

}  // namespace ridgeline::reconstruct
