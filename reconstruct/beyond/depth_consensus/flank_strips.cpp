// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/flank_strips.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/views/strip_look.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Longest reach of the right strip beyond its segment.
constexpr double kMostBeyond_px = 500.0;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

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
  strip.is_cut = {is_at_border(image, segment.in_image.start),
                  is_at_border(image, segment.in_image.end)};
  std::vector<Eigen::Vector2d> on_line;
  for (int i = 0; i < strip.n_along; ++i) {
    const double t = from + (to - from) * i / (strip.n_along - 1);
    // from ideal to file pixels as at the nearest end: it hardly changes along a segment
    const double near = std::clamp(t, 0.0, 1.0);
    on_line.push_back(point_at(ideal, t) +
                      (point_at(segment.in_image, near) - point_at(ideal, near)));
  }
  const StripGrid grid{.first_offset_px = FlankStrip::kFirstRow_px,
                       .offset_step_px = FlankStrip::kRowStep_px,
                       .n_offsets = FlankStrip::kRows};
  for (const std::size_t side : {0U, 1U}) {
    const Eigen::Vector2d away = (side == 0 ? 1.0 : -1.0) * normal(ideal);
    const Strip seen = sample_strip(sampler, on_line, away, grid);
    for (int row = 0; row < FlankStrip::kRows; ++row) {
      for (int band = 0; band < strip.n_bands; ++band) {
        for (std::size_t i = row; i < seen.colours.size(); i += FlankStrip::kRows) {
          strip.sides[side].push_back(seen.is_inside[i] ? seen.colours[i][band] : kNaN);
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
