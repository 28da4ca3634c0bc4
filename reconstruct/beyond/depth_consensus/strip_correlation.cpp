// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/strip_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ridgeline::reconstruct {
namespace {

constexpr int kRows = FlankStrip::kRows;
constexpr double kSlopeStep = 0.8;                // of the sides
constexpr double kNoiseVariance = 0.008 * 0.008;  // of a band

/// Values of one row and band; samples outside of the image take the mean of the others.
std::vector<float> without_gaps(const float* row, int n) {
  std::vector<float> filled(row, row + n);
  double sum = 0.0;
  int count = 0;
  for (const float value : filled) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  const float mean = count > 0 ? static_cast<float>(sum / count) : 0.0F;
  // about the mean, so that places without a sample add nothing
  for (float& value : filled) value = std::isnan(value) ? 0.0F : value - mean;
  return filled;
}

/// The samples that take part, less their mean.
std::vector<float> taken(const std::vector<float>& row, const std::vector<int>& columns) {
  std::vector<float> values;
  double sum = 0.0;
  for (const int column : columns) {
    values.push_back(row[static_cast<std::size_t>(column)]);
    sum += values.back();
  }
  const auto mean = static_cast<float>(sum / static_cast<double>(values.size()));
  for (float& value : values) value -= mean;
  return values;
}

/// The row as read at places that lie further along it; 0, its mean, beyond its ends.
std::vector<float> shifted(const std::vector<float>& row, double shift) {
  const auto n = static_cast<int>(row.size());
  const double whole = std::floor(shift);
  const auto share = static_cast<float>(shift - whole);
  const auto value = [&](int i) {
    return i >= 0 && i < n ? row[static_cast<std::size_t>(i)] : 0.0F;
  };
  std::vector<float> there(row.size());
  for (int i = 0; i < n; ++i) {
    const int from = i + static_cast<int>(whole);
    there[static_cast<std::size_t>(i)] = (1.0F - share) * value(from) + share * value(from + 1);
  }
  return there;
}

/// @param products  [left sample][place]
void add_products(const std::vector<float>& left,
                  const std::vector<float>& right,
                  std::vector<float>& products) {
  float* product = products.data();
  for (const float a : left) {
    for (const float b : right) *product++ += a * b;
  }
}

}  // namespace

StripCorrelation::StripCorrelation(const FlankStrips& strips,
                                   std::vector<int> columns,
                                   bool swap_sides,
                                   double parallax)
    : n_right_(strips.right.n_along),
      parallax_(parallax),
      noise_(kNoiseVariance * kRows * strips.left.n_bands),
      columns_(std::move(columns)) {
  for (const std::size_t side : {0U, 1U}) {
    sides_[side] = side_of(strips, side, swap_sides ? 1 - side : side);
  }
}

StripCorrelation::RowSums StripCorrelation::running_sums(const std::vector<float>& row) {
  RowSums sums;
  sums.values.assign(row.size() + 1, 0.0);
  sums.squares.assign(row.size() + 1, 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double value = row[i];
    sums.values[i + 1] = sums.values[i] + value;
    sums.squares[i + 1] = sums.squares[i] + value * value;
  }
  return sums;
}

StripCorrelation::Moments StripCorrelation::moments(const RowSums& row,
                                                    std::size_t from,
                                                    std::size_t to) {
  const auto n = static_cast<double>(to - from);
  const double mean = (row.values[to] - row.values[from]) / n;
  return {mean, std::max(0.0, (row.squares[to] - row.squares[from]) / n - mean * mean)};
}

/// Samples along the right strip by which a row of a side that slopes is shifted.
double StripCorrelation::shift(std::size_t slope, int row) const {
  const double from_line_px = FlankStrip::kFirstRow_px + row * FlankStrip::kRowStep_px;
  const double rise = kSlopeStep * (static_cast<double>(slope) - static_cast<double>(kLevel));
  return rise * parallax_ * from_line_px / FlankStrip::kRightStep_px;
}

StripCorrelation::Side StripCorrelation::side_of(const FlankStrips& strips,
                                                 std::size_t side,
                                                 std::size_t right_side) const {
  const auto n = static_cast<std::size_t>(n_right_);
  Side sums;
  for (auto& products : sums.products) products.assign(n_samples() * n, 0.0F);
  // the row farthest from the line leaves the image first
  const float* farthest = strips.right.row(right_side, kRows - 1, 0);
  const auto is_inside = [](float value) { return !std::isnan(value); };
  const float* first = std::find_if(farthest, farthest + n_right_, is_inside);
  sums.first_inside = static_cast<int>(first - farthest);
  sums.end_inside =
      static_cast<int>(std::find_if_not(first, farthest + n_right_, is_inside) - farthest);
  for (int row = 0; row < kRows; ++row) {
    for (int band = 0; band < strips.left.n_bands; ++band) {
      const std::vector<float> left =
          taken(without_gaps(strips.left.row(side, row, band), strips.left.n_along), columns_);
      const std::vector<float> right =
          without_gaps(strips.right.row(right_side, row, band), n_right_);
      sums.left.push_back(running_sums(left));
      sums.left_variance += moments(sums.left.back(), 0, n_samples()).variance;
      sums.right.push_back(running_sums(right));
      for (std::size_t slope = 0; slope < kSlopes; ++slope) {
        add_products(left, shifted(right, shift(slope, row)), sums.products[slope]);
      }
    }
  }
  return sums;
}

std::optional<StripCorrelation::Cover> StripCorrelation::cover(
    const Side& side, std::span<const double> places) const {
  Cover c{0, n_samples(), 0.0, 0.0};
  while (c.first < c.end && !is_inside(side, places[c.first])) ++c.first;
  while (c.end > c.first && !is_inside(side, places[c.end - 1])) --c.end;
  if (2 * (c.end - c.first) < n_samples()) return std::nullopt;
  const auto [low, high] = std::minmax(places[c.first], places[c.end - 1]);
  const auto from = static_cast<std::size_t>(low);
  const auto to = static_cast<std::size_t>(high) + 2;
  const bool is_whole = c.first == 0 && c.end == n_samples();
  double left_variance = noise_ + (is_whole ? side.left_variance : 0.0);
  double right_variance = noise_;
  for (std::size_t i = 0; i < side.left.size(); ++i) {
    const Moments right = moments(side.right[i], from, to);
    right_variance += right.variance;
    if (is_whole) continue;  // of mean zero
    const Moments left = moments(side.left[i], c.first, c.end);
    c.product_of_means += left.mean * right.mean;
    left_variance += left.variance;
  }
  c.norm = std::sqrt(left_variance * right_variance);
  return c;
}

double StripCorrelation::correlation(const Side& side,
                                     std::size_t slope,
                                     std::span<const double> places,
                                     const Cover& cover) const {
  double product = 0.0;
  for (std::size_t s = cover.first; s < cover.end; ++s) {
    if (!is_inside(side, places[s])) continue;
    const auto place = static_cast<int>(places[s]);
    const double share = places[s] - place;
    const float* products =
        side.products[slope].data() + s * static_cast<std::size_t>(n_right_) + place;
    product += (1.0 - share) * products[0] + share * products[1];
  }
  return (product / static_cast<double>(cover.end - cover.first) - cover.product_of_means) /
         cover.norm;
}

double StripCorrelation::at_slope(std::size_t side,
                                  std::size_t slope,
                                  std::span<const double> places) const {
  const auto covered = cover(sides_[side], places);
  return covered ? correlation(sides_[side], slope, places, *covered) : 0.0;
}

double StripCorrelation::best(std::size_t side, std::span<const double> places) const {
  const auto covered = cover(sides_[side], places);
  if (!covered) return 0.0;
  double best = -1.0;
  for (std::size_t slope = 0; slope < kSlopes; ++slope) {
    best = std::max(best, correlation(sides_[side], slope, places, *covered));
  }
  return best;
}

}  // namespace ridgeline::reconstruct
