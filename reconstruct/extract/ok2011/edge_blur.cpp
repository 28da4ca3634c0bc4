// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_blur.h"

#include "reconstruct/appearance/colour_profile.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr double kMinBlur_px = 0.35;
constexpr double kStep_px = 0.05;
constexpr std::size_t kNumBlurs = 24;

double half_width_px() { return profile_half_width_px(kTypicalBlur_px); }
double blur_px(std::size_t i) { return kMinBlur_px + kStep_px * static_cast<double>(i); }

/// The blur at which one step describes the profile best, if that step describes it well.
std::optional<double> best_blur_px(const BinnedProfile& profile, std::span<const StepBasis> bases) {
  // Maximum share of the profile's sum of squares that one step may leave unexplained at a clean
  // edge.
  constexpr double kMaxUnexplainedShare = 0.15;
  double best = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    const double gain = best_gain(bases[i], profile);
    if (gain <= best) continue;
    best = gain;
    at = i;
  }
  if (profile.squares - best >= kMaxUnexplainedShare * profile.squares) return std::nullopt;
  return blur_px(at);
}

/// The median blur in units of `unit_px`.
std::optional<double> median_blur(const cv::Mat& image,
                                  std::span<const Segment2> segments,
                                  std::span<const StepBasis> bases,
                                  double unit_px) {
  constexpr std::size_t kMaxSegments = 200;
  constexpr double kMinLength_px = 30.0;
  constexpr std::size_t kMinEdges = 5;
  std::vector<double> blurs;
  std::size_t n_seen = 0;
  for (const Segment2& segment : segments) {
    if (length(segment) < kMinLength_px) continue;
    if (++n_seen > kMaxSegments) break;
    const std::vector<ProfileSample> samples =
        profile_samples(image, segment, half_width_px(), unit_px);
    if (samples.size() < kMinProfileSamples) continue;
    if (const auto blur = best_blur_px(BinnedProfile(samples, half_width_px()), bases)) {
      blurs.push_back(*blur);
    }
  }
  if (blurs.size() < kMinEdges) return std::nullopt;
  return upper_median(std::move(blurs));
}

}  // namespace

std::optional<double> edge_blur_px(const cv::Mat& image, std::span<const Segment2> segments) {
  constexpr double kMaxOffset_px = 1.0;
  constexpr double kMaxBlur_px = 1.35;  // wider edges are measured in units twice as large
  std::vector<StepBasis> bases;
  bases.reserve(kNumBlurs);
  for (std::size_t i = 0; i < kNumBlurs; ++i) {
    bases.emplace_back(half_width_px(), kMaxOffset_px, blur_px(i));
  }
  std::optional<double> blur_px;
  for (const double unit_px : {1.0, 2.0, 4.0}) {
    const auto blur = median_blur(image, segments, bases, unit_px);
    if (!blur) break;
    blur_px = *blur * unit_px;
    if (*blur < kMaxBlur_px) break;
  }
  return blur_px;
}

std::optional<double> blur_of_longest_px(const cv::Mat& image,
                                         std::span<const EdgeSegment> segments) {
  std::vector<Segment2> lines = transformed(segments, &EdgeSegment::in_image);
  std::ranges::stable_sort(lines, std::greater{},
                           [](const Segment2& line) { return length(line); });
  return edge_blur_px(image, std::span<const Segment2>(lines));
}

}  // namespace ridgeline::reconstruct
