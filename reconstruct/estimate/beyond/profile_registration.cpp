// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/profile_registration.h"

#include "reconstruct/appearance/strip_appearance.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar_overlap.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/parabola.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kShiftStep_px = 0.125;
constexpr int kHalfWidth = 16;  // half width of the left profile, in steps: 2 px
constexpr int kMaxShift = 20;   // largest shift, in steps: 2.5 px
constexpr int kMaxRows = 40;    // maximum number of rows over which a profile is averaged

/// Profiles at least this similar show the same surfaces on both sides.
constexpr double kMinNcc = 0.985;
/// Profiles are registered if that increases their correlation by at least this much. Both limits
/// were chosen from the true errors in simulated training villages: 31 of 37 registered lines come
/// closer to the true line, 3 move away.
constexpr double kMinGain = 0.003;

/// Mean colours along a line at steps across it, -n..n; empty if a sample lies outside the image.
std::vector<Colour> profile_across(const ImageSampler& image,
                                   const std::vector<Eigen::Vector2d>& on_line,
                                   const Eigen::Vector2d& side,
                                   int n) {
  const StripGrid grid{.first_offset_px = -n * kShiftStep_px,
                       .offset_step_px = kShiftStep_px,
                       .n_offsets = 2 * n + 1};
  return mean_profile(sample_strip(image, on_line, side, grid), grid);
}

/// Finds the shift at which the longer right profile shows the left one.
ComparedProfiles compared(std::span<const Colour> left, std::span<const Colour> right) {
  std::array<double, 2 * kMaxShift + 1> at{};
  for (std::size_t k = 0; k < at.size(); ++k)
    at[k] = correlation(left, right.subspan(k, left.size()));
  const auto best = std::max_element(at.begin(), at.end());
  const ComparedProfiles unmoved{0.0, at[kMaxShift]};
  if (best == at.begin() || best == at.end() - 1) return unmoved;
  if (*best < kMinNcc || *best - at[kMaxShift] < kMinGain) return unmoved;
  return {kShiftStep_px * (static_cast<double>(best - at.begin()) - kMaxShift +
                           vertex_of_parabola(best[-1], *best, best[1])),
          *best};
}

ComparedProfiles profiles_of_match(const StereoSearch& search,
                                   const std::array<ImageSampler, 2>& images,
                                   const EdgeSegment& left,
                                   const EdgeSegment& right) {
  const auto searched = searched_segment(search, left.line.segment);
  if (!searched) return {};
  const auto overlap = epipolar_overlap(*searched, right.line.segment);
  if (!overlap) return {};
  // Steps are in pixels of each view, unless only one of the views is reduced.
  constexpr double kMaxScaleRatio = 1.5;
  const Eigen::Matrix2d jacobian = local_transfer(search, midpoint(left.line.segment)).jacobian;
  const double right_px_per_left_px = std::sqrt(std::abs(jacobian.determinant()));
  const bool is_unlike =
      right_px_per_left_px > kMaxScaleRatio || right_px_per_left_px < 1.0 / kMaxScaleRatio;
  const StripFrame frame = strip_frame({left, right, *overlap}, kMaxRows);
  // The sides are those of the left segment, whatever the direction of the right one.
  const double sign = overlap->reversed() ? -1.0 : 1.0;
  const double right_step_px = frame.scale_px * (is_unlike ? right_px_per_left_px : 1.0);
  const Eigen::Vector2d side_in_right = sign * right_step_px * normal(right.line.segment);
  const std::vector<Colour> seen_left =
      profile_across(images[0], frame.on_left, frame.side_in_left, kHalfWidth);
  const std::vector<Colour> seen_right =
      profile_across(images[1], frame.on_right, side_in_right, kHalfWidth + kMaxShift);
  if (seen_left.empty() || seen_right.empty()) return {};
  ComparedProfiles both = compared(seen_left, seen_right);
  both.right_shift_px *= sign * right_step_px;
  return both;
}

}  // namespace

std::vector<ComparedProfiles> compare_profiles(const StereoPair& pair,
                                               std::span<const Correspondence> matches,
                                               double max_angle_deg) {
  const StereoSearch search = searched(pair).search;
  const std::array<ImageSampler, 2> samplers{ImageSampler(pair.views[0]->image),
                                             ImageSampler(pair.views[1]->image)};
  std::vector<ComparedProfiles> profiles(matches.size());
  tbb::parallel_for(std::size_t{0}, matches.size(), [&](std::size_t i) {
    Interruption::check();
    const EdgeSegment& left = pair.views[0]->segments.at(static_cast<std::size_t>(matches[i].base));
    const EdgeSegment& right =
        pair.views[1]->segments.at(static_cast<std::size_t>(matches[i].other));
    const double angle_rad =
        epipolar_angle_rad(pair.cameras(), left.line.segment, right.line.segment);
    if (angle_rad <= max_angle_deg * kRadPerDeg) return;
    profiles[i] = profiles_of_match(search, samplers, left, right);
  });
  return profiles;
}

}  // namespace ridgeline::reconstruct
