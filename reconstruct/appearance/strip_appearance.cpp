// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/strip_appearance.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kAlongStep_px = 1.5;
constexpr int kMinSamplesAlong = 4;
/// Variance of the grey values due to noise. It prevents noise from contributing to the
/// correlation.
constexpr double kNoiseVariance = 0.008 * 0.008;

/// The shift from ideal to file pixels at a given parameter of a segment.
Eigen::Vector2d file_shift(const EdgeSegment& segment, double t) {
  return point_at(segment.in_image, t) - point_at(segment.line.segment, t);
}

}  // namespace

double SideAppearance::colour_agreement() const {
  constexpr double kScale = 0.05;  // in units of the range of grey values
  return std::exp(-colour_difference / kScale);
}

double correlation(std::span<const BandSums> bands, int n_samples, double noise_variance) {
  double covariance = 0.0;
  double variance_a = 0.0;
  double variance_b = 0.0;
  const double n = n_samples;
  for (const BandSums& s : bands) {
    covariance += s.ab / n - s.a * s.b / (n * n);
    variance_a += s.aa / n - s.a * s.a / (n * n);
    variance_b += s.bb / n - s.b * s.b / (n * n);
  }
  const double noise = static_cast<double>(bands.size()) * noise_variance;
  const double scale = std::sqrt((variance_a + noise) * (variance_b + noise));
  return scale > 0.0 ? covariance / scale : 0.0;
}

double correlation(std::span<const Colour> a, std::span<const Colour> b, double noise_variance) {
  std::array<BandSums, kMaxBands> sums{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t band = 0; band < kMaxBands; ++band) sums[band].add(a[i][band], b[i][band]);
  }
  return correlation(sums, static_cast<int>(a.size()), noise_variance);
}

SideAppearance side_appearance(const std::array<BandSums, kMaxBands>& sums,
                               int n_bands,
                               int n_samples) {
  double squared_difference = 0.0;
  for (int band = 0; band < n_bands; ++band) {
    const double difference = (sums[band].a - sums[band].b) / n_samples;
    squared_difference += difference * difference;
  }
  const std::span<const BandSums> seen(sums.data(), static_cast<std::size_t>(n_bands));
  return {correlation(seen, n_samples, kNoiseVariance), std::sqrt(squared_difference / n_bands)};
}

StripFrame strip_frame(const EdgePair& edges, int most_along) {
  const auto& [left, right, overlap] = edges;
  const Segment2& segment = left.line.segment;
  const double length_px = overlap.share_of_left() * length(segment);
  StripFrame frame;
  frame.scale_px = std::max(left.scale_px, right.scale_px);
  const int n = std::clamp(static_cast<int>(length_px / (kAlongStep_px * frame.scale_px)),
                           kMinSamplesAlong, most_along);
  for (int i = 0; i < n; ++i) {
    const double share = (i + 0.5) / n;
    const double on_left = overlap.on_left[0] + share * overlap.share_of_left();
    const double on_right = overlap.right_of(on_left);
    frame.on_left.push_back(point_at(left.in_image, on_left));
    // Outside the segment, the shift of the nearest end is used, because the shift hardly changes
    // along a segment.
    frame.on_right.push_back(point_at(right.line.segment, on_right) +
                             file_shift(right, std::clamp(on_right, 0.0, 1.0)));
  }
  frame.side_in_left = frame.scale_px * normal(segment);
  return frame;
}

Strip sample_strip(const ImageSampler& image,
                   std::span<const Eigen::Vector2d> on_line,
                   const Eigen::Vector2d& side,
                   const StripGrid& grid) {
  Strip strip;
  strip.colours.resize(on_line.size() * grid.n_offsets);
  strip.is_inside.resize(strip.colours.size());
  std::size_t next = 0;
  for (const Eigen::Vector2d& x : on_line) {
    for (int k = 0; k < grid.n_offsets; ++k, ++next) {
      const double offset_px = grid.first_offset_px + k * grid.offset_step_px;
      strip.is_inside[next] =
          image.sample(x + offset_px * side, strip.colours[next]) ? char{1} : char{0};
    }
  }
  return strip;
}

std::vector<Colour> mean_profile(const Strip& strip, const StripGrid& grid) {
  if (std::count(strip.is_inside.begin(), strip.is_inside.end(), char{0}) > 0) return {};
  std::vector<Colour> profile(static_cast<std::size_t>(grid.n_offsets), Colour{});
  for (std::size_t i = 0; i < strip.colours.size(); ++i) {
    Colour& sum = profile[i % profile.size()];
    for (std::size_t band = 0; band < sum.size(); ++band) sum[band] += strip.colours[i][band];
  }
  const std::size_t n = strip.colours.size() / profile.size();
  for (Colour& sum : profile) {
    for (float& value : sum) value /= static_cast<float>(n);
  }
  return profile;
}

std::optional<SideAppearance> compare(const Strip& left,
                                      const Strip& right,
                                      const Radiometry& radiometry,
                                      int n_bands) {
  std::array<BandSums, kMaxBands> sums{};
  std::size_t n_samples = 0;
  for (std::size_t i = 0; i < left.colours.size(); ++i) {
    if (!left.is_inside[i] || !right.is_inside[i]) continue;
    ++n_samples;
    const Colour mapped = radiometry.left_from_right(right.colours[i]);
    for (int band = 0; band < n_bands; ++band) sums[band].add(left.colours[i][band], mapped[band]);
  }
  if (2 * n_samples < left.colours.size()) return std::nullopt;
  return side_appearance(sums, n_bands, static_cast<int>(n_samples));
}

}  // namespace ridgeline::reconstruct
