// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/predicted_counterpart.h"

#include "reconstruct/surface/side_planes.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Mean of the known disparities.
double mean_of(const cv::Mat& disparity_px) {
  double sum = 0.0;
  std::size_t n = 0;
  for (int row = 0; row < disparity_px.rows; ++row) {
    for (int column = 0; column < disparity_px.cols; ++column) {
      const float d = disparity_px.at<float>(row, column);
      if (std::isnan(d)) continue;
      sum += double{d};
      ++n;
    }
  }
  return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

/// The disparities by the pixels of the right view. If two surfaces fall on one of its pixels, the
/// nearer one hides the other: it has the larger disparity, so it comes from a later column and
/// overwrites the other.
/// @param moved_px  shift of those pixels along the rows
cv::Mat seen_from_right(const cv::Mat& disparity_px, double moved_px) {
  cv::Mat right(disparity_px.size(), CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int row = 0; row < right.rows; ++row) {
    for (int column = 0; column < right.cols; ++column) {
      const float d = disparity_px.at<float>(row, column);
      if (std::isnan(d)) continue;
      const double at = std::round(column - double{d} + moved_px);
      if (!(at >= 0.0 && at < right.cols)) continue;
      right.at<float>(row, static_cast<int>(at)) = d;
    }
  }
  return right;
}

}  // namespace

PredictedCounterpart::PredictedCounterpart(const Surface& surface, std::size_t from)
    : surface_(surface),
      from_(from),
      ideal_from_rectified_(surface.rectification.rectified_from_ideal[1 - from].inverse()) {
  if (from == 0) return;
  moved_px_ = std::round(mean_of(surface.disparity_px));
  surface_.disparity_px = seen_from_right(surface.disparity_px, moved_px_);
}

std::optional<Segment2> PredictedCounterpart::of(const Segment2& segment) const {
  constexpr double kMinSine = 0.17;  // minimum sine of the angle to the rows
  const Eigen::Vector2d moved(moved_px_, 0.0);
  const Segment2 rectified{surface_.rectification.rectified(from_, segment.start) + moved,
                           surface_.rectification.rectified(from_, segment.end) + moved};
  if (std::abs(along(rectified).y()) < kMinSine) return std::nullopt;
  const SidesOfPiece whole = sides_of(surface_, rectified, {0.0, 1.0});
  const SidePlane* nearer = whole.nearer();
  if (nearer == nullptr || !nearer->is_trusted()) return std::nullopt;
  const auto in_other = [&](const Eigen::Vector2d& x, double t_px) -> Eigen::Vector2d {
    const double d_px = nearer->on_line(t_px);
    const Eigen::Vector2d seen = x - moved + Eigen::Vector2d(from_ == 0 ? -d_px : d_px, 0.0);
    return (ideal_from_rectified_ * seen.homogeneous()).hnormalized();
  };
  const double half_px = 0.5 * whole.length_px;
  return Segment2{in_other(rectified.start, -half_px), in_other(rectified.end, half_px)};
}

}  // namespace ridgeline::reconstruct
