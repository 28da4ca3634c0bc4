// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/flank_strips.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/views/image_sampler.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Longest reach of the right strip beyond its segment.
constexpr double kMostBeyond_px = 500.0;

bool is_at_border(const cv::Mat& image, const Eigen::Vector2d& x) {
  constexpr double kBorder_px = 3.0;
  return x.x() < kBorder_px || x.y() < kBorder_px || x.x() > image.cols - 1.0 - kBorder_px ||
         x.y() > image.rows - 1.0 - kBorder_px;
}

/// @param from, to  parameters of the segment
FlankStrip sample(
    const cv::Mat& image, const EdgeSegment& segment, double from, double to, double step_px) {
  const ImageSampler sampler(image);
  const Segment2& ideal = segment.line.segment;
  const Eigen::Vector2d along = ideal.end - ideal.start;
  FlankStrip strip;
  strip.n_along = std::max(2, static_cast<int>((to - from) * along.norm() / step_px) + 1);
  strip.n_bands = sampler.n_bands();
  strip.axis = {ideal.start + from * along, ideal.start + to * along};
  const Eigen::Vector2d u = along.normalized();
  const Eigen::Vector2d across(-u.y(), u.x());
  strip.is_cut = {is_at_border(image, segment.in_image.start),
                  is_at_border(image, segment.in_image.end)};
  const auto n = static_cast<std::size_t>(strip.n_along);
  for (const std::size_t side : {0U, 1U}) {
    std::vector<float>& values = strip.sides[side];
    values.assign(n * static_cast<std::size_t>(FlankStrip::kRows * strip.n_bands),
                  std::numeric_limits<float>::quiet_NaN());
    for (int row = 0; row < FlankStrip::kRows; ++row) {
      const double offset =
          (side == 0 ? 1.0 : -1.0) * (FlankStrip::kFirstRow_px + row * FlankStrip::kRowStep_px);
      for (std::size_t i = 0; i < n; ++i) {
        const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(n - 1);
        // from ideal to file pixels as at the nearest end: it hardly changes along a segment
        const double near = std::clamp(t, 0.0, 1.0);
        const Eigen::Vector2d shift = segment.in_image.start +
                                      near * (segment.in_image.end - segment.in_image.start) -
                                      (ideal.start + near * along);
        Colour colour{};
        if (!sampler.sample(ideal.start + t * along + shift + offset * across, colour)) continue;
        for (int band = 0; band < strip.n_bands; ++band) {
          values[static_cast<std::size_t>(row * strip.n_bands + band) * n + i] = colour[band];
        }
      }
    }
  }
  return strip;
}

/// Parameter of a segment of the right image where it shows a pixel of the left one at a height.
double parameter_in_right(const std::array<ProjectionMatrix, 2>& cameras,
                          const Segment2& right,
                          const Eigen::Vector2d& x_in_left,
                          double height_m) {
  const Plane3 level(Eigen::Vector3d::UnitZ(), -height_m);
  const Eigen::Vector2d x = project(cameras[1], point_on_plane(cameras[0], x_in_left, level));
  return parameter_along(right, x);
}

FlankStrips sample_match(const StereoPair& pair,
                         const EdgeSegment& left,
                         const EdgeSegment& right) {
  const double most = kMostBeyond_px / length(right.line.segment);
  double from = 0.0;
  double to = 1.0;
  for (const Eigen::Vector2d& x : {left.line.segment.start, left.line.segment.end}) {
    for (const double height_m : pair.height_range_in_local_m) {
      const double t = parameter_in_right(pair.cameras(), right.line.segment, x, height_m);
      if (!std::isfinite(t)) continue;
      from = std::clamp(t, -most, from);
      to = std::clamp(t, to, 1.0 + most);
    }
  }
  return {sample(pair.views[0].image, left, 0.0, 1.0, FlankStrip::kLeftStep_px),
          sample(pair.views[1].image, right, from, to, FlankStrip::kRightStep_px)};
}

}  // namespace

std::vector<FlankStrips> sample_flanks(const StereoPair& pair,
                                       std::span<const LineMatch> matches,
                                       double max_angle_deg) {
  std::vector<FlankStrips> strips(matches.size());
  tbb::parallel_for(std::size_t{0}, matches.size(), [&](std::size_t i) {
    const EdgeSegment& left = pair.views[0].segments.at(static_cast<std::size_t>(matches[i].left));
    const EdgeSegment& right =
        pair.views[1].segments.at(static_cast<std::size_t>(matches[i].right));
    const double angle_rad =
        epipolar_angle_rad(pair.cameras(), left.line.segment, right.line.segment);
    if (angle_rad > max_angle_deg * kRadPerDeg) return;
    strips[i] = sample_match(pair, left, right);
  });
  return strips;
}

}  // namespace ridgeline::reconstruct
