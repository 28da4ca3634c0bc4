// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/edge_appearance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

/// tan(35 deg), a common slope of roofs. If the true slope differs by 20 degrees, a strip 8 px wide
/// is sheared by less than a pixel at a base-to-height ratio of 0.26.
constexpr double kSlope = 0.7;

/// The profile across the line: 4 px on each side in steps of half a pixel.
constexpr StripGrid kProfileGrid{.first_offset_px = -4.0, .offset_step_px = 0.5, .n_offsets = 17};

std::optional<double> profile_ncc(const ImagePair& images, const StripFrame& frame) {
  const auto seen = [](const ImageSampler& image, const std::vector<Eigen::Vector2d>& on_line,
                       const Eigen::Vector2d& side) {
    return mean_profile(sample_strip(image, on_line, side, kProfileGrid), kProfileGrid);
  };
  const std::vector<Colour> left = seen(images.left, frame.on_left, frame.side_in_left);
  std::vector<Colour> right = seen(images.right, frame.on_right, frame.side_in_right);
  if (left.empty() || right.empty()) return std::nullopt;
  std::array<BandSums, kMaxBands> sums{};
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Colour mapped = images.radiometry.left_from_right(right[k]);
    for (int band = 0; band < images.left.n_bands(); ++band) {
      sums[band].add(left[k][band], mapped[band]);
    }
  }
  return side_appearance(sums, images.left.n_bands(), static_cast<int>(left.size())).ncc;
}

struct FlankMoments {
  std::array<double, kMaxBands> mean{}, spread{};
};
FlankMoments flank_moments(std::span<const EdgeSegment> segments) {
  std::array<BandSums, kMaxBands> sums{};
  for (const EdgeSegment& segment : segments) {
    for (const Flank* flank : {&segment.left, &segment.right}) {
      for (int band = 0; band < kMaxBands; ++band) sums[band].add(flank->colour[band], 0.0);
    }
  }
  const double n = 2.0 * static_cast<double>(segments.size());
  FlankMoments moments;
  for (int band = 0; band < kMaxBands; ++band) {
    moments.mean[band] = sums[band].a / n;
    const double variance = sums[band].aa / n - moments.mean[band] * moments.mean[band];
    moments.spread[band] = std::sqrt(std::max(0.0, variance));
  }
  return moments;
}

}  // namespace

Radiometry relative_radiometry(std::span<const EdgeSegment> left,
                               std::span<const EdgeSegment> right) {
  constexpr std::size_t kMinSegments = 10;
  Radiometry radiometry;
  if (left.size() < kMinSegments || right.size() < kMinSegments) return radiometry;
  const FlankMoments a = flank_moments(left);
  const FlankMoments b = flank_moments(right);
  for (int band = 0; band < kMaxBands; ++band) {
    if (!(a.spread[band] > 0.0 && b.spread[band] > 0.0)) continue;
    radiometry.gain[band] = static_cast<float>(a.spread[band] / b.spread[band]);
    radiometry.offset[band] =
        static_cast<float>(a.mean[band] - radiometry.gain[band] * b.mean[band]);
  }
  return radiometry;
}

EdgeAppearance edge_appearance(const ImagePair& images,
                               const EdgePair& edges,
                               const LocalTransfer& transfer,
                               const StripGrid& grid) {
  StripFrame frame = strip_frame(edges, grid.most_along);
  EdgeAppearance appearance;
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? -1.0 : 1.0;
    const Strip on_left = sample_strip(images.left, frame.on_left, sign * frame.side_in_left, grid);
    for (int slope = 0; slope < grid.n_slopes; ++slope) {
      const double height_per_px = (slope == 0   ? 0.0
                                    : slope == 1 ? kSlope
                                                 : -kSlope) *
                                   transfer.gsd_m * frame.scale_px;
      frame.side_in_right =
          transfer.jacobian * frame.side_in_left + height_per_px * transfer.per_height;
      const Strip on_right =
          sample_strip(images.right, frame.on_right, sign * frame.side_in_right, grid);
      const std::optional<SideAppearance> found =
          compare(on_left, on_right, images.radiometry, images.left.n_bands());
      std::optional<SideAppearance>& best = appearance.sides[side];
      if (found && (!best || found->ncc > best->ncc)) best = found;
    }
  }
  if (grid.with_profile) {
    frame.side_in_right = transfer.jacobian * frame.side_in_left;
    appearance.profile_ncc = profile_ncc(images, frame);
  }
  return appearance;
}

}  // namespace ridgeline::reconstruct
