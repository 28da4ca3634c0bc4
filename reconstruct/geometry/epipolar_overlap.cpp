// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/epipolar_overlap.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Minimum share of the shorter of two near-aligned segments that the overlap must cover.
constexpr double kMinAlignedShare = 0.5;

/// The overlap if the left ends correspond to the right parameters t at heights z; std::nullopt if
/// it is empty.
std::optional<EpipolarOverlap> overlap_of(const std::array<double, 2>& t,
                                          const std::array<double, 2>& z) {
  const double rate = t[1] - t[0];
  if (!std::isfinite(rate) || std::abs(rate) < 1e-9) return std::nullopt;
  const double u_of_start = -t[0] / rate;
  const double u_of_end = (1.0 - t[0]) / rate;
  const double low = std::max(0.0, std::min(u_of_start, u_of_end));
  const double high = std::min(1.0, std::max(u_of_start, u_of_end));
  if (!(low < high)) return std::nullopt;
  EpipolarOverlap overlap;
  overlap.on_left = {low, high};
  overlap.on_right = {t[0] + low * rate, t[0] + high * rate};
  overlap.height_m = {z[0] + low * (z[1] - z[0]), z[0] + high * (z[1] - z[0])};
  return overlap;
}

/// The height at which a stretch crosses the line through y that is normal to the epipolar
/// direction.
double height_beside(const Stretch& stretch,
                     const Eigen::Vector2d& direction,
                     const Eigen::Vector2d& y) {
  return stretch.height_on(direction, direction.dot(y));
}

/// The overlap if the left ends have the heights z; std::nullopt if the transferred ends miss the
/// right line.
std::optional<EpipolarOverlap> aligned_overlap(const SearchedSegment& left,
                                               const Segment2& right,
                                               const std::array<double, 2>& z,
                                               double tolerance_px) {
  const Eigen::Vector2d y_start = left.start.at(z[0]);
  const Eigen::Vector2d y_end = left.end.at(z[1]);
  std::optional<EpipolarOverlap> overlap =
      overlap_of({parameter_along(right, y_start), parameter_along(right, y_end)}, z);
  if (!overlap) return std::nullopt;
  const Eigen::Vector2d n = normal(right);
  for (const double u : overlap->on_left) {
    const Eigen::Vector2d y = (1.0 - u) * y_start + u * y_end;
    if (std::abs(n.dot(y) - n.dot(right.start)) > tolerance_px) return std::nullopt;
  }
  overlap->aligned = true;
  return overlap;
}

bool covers_enough(const EpipolarOverlap& overlap) {
  return std::max(overlap.share_of_left(), overlap.share_of_right()) >= kMinAlignedShare;
}

bool disjoint(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  constexpr double kShared = 0.5;  // share of the shorter interval; end points are uncertain
  const auto [a_low, a_high] = std::minmax(a[0], a[1]);
  const auto [b_low, b_high] = std::minmax(b[0], b[1]);
  const double common = std::min(a_high, b_high) - std::max(a_low, b_low);
  return common <= kShared * std::min(a_high - a_low, b_high - b_low);
}

}  // namespace

double EpipolarOverlap::right_of(double on_left_parameter) const {
  return on_right[0] +
         (on_left_parameter - on_left[0]) * (on_right[1] - on_right[0]) / (on_left[1] - on_left[0]);
}

double EpipolarOverlap::height_at(double on_left_parameter) const {
  return height_m[0] +
         (on_left_parameter - on_left[0]) * (height_m[1] - height_m[0]) / (on_left[1] - on_left[0]);
}

std::optional<SearchedSegment> searched_segment(const StereoSearch& search,
                                                const Segment2& left_segment) {
  const auto [lowest, highest] = search.height_range_m;
  const double middle_m = 0.5 * (lowest + highest);
  SearchedSegment searched;
  searched.segment = left_segment;
  searched.start = search.right_from_left.stretch(left_segment.start);
  searched.end = search.right_from_left.stretch(left_segment.end);
  const Stretch centre = search.right_from_left.stretch(midpoint(left_segment));
  const Eigen::Vector2d per_height = centre.derivative(middle_m);
  // If the third coordinate changes sign within the height range, the ray meets the plane of the
  // projection centre.
  const double depth =
      (centre.a.z() + lowest * centre.b.z()) * (centre.a.z() + highest * centre.b.z());
  if (!per_height.allFinite() || per_height.norm() <= 0.0 || !(depth > 0.0)) return std::nullopt;
  searched.px_per_m = per_height.norm();
  searched.epipolar_direction = per_height / searched.px_per_m;
  const Eigen::Vector3d line_in_left =
      search.right_from_left.fundamental().transpose() * centre.at(middle_m).homogeneous();
  searched.epipolar_angle_rad =
      acute_angle_rad(Eigen::Vector2d(left_segment.end - left_segment.start),
                      Eigen::Vector2d(-line_in_left.y(), line_in_left.x()));
  return searched;
}

bool is_near_aligned(const SearchedSegment& left, const Segment2& right, double min_angle_rad) {
  return left.epipolar_angle_rad < min_angle_rad ||
         acute_angle_rad(Eigen::Vector2d(right.end - right.start), left.epipolar_direction) <
             min_angle_rad;
}

std::optional<EpipolarOverlap> epipolar_overlap(const SearchedSegment& left,
                                                const Segment2& right) {
  const Eigen::Vector2d n = normal(right);
  const double c = n.dot(right.start);
  const std::array<double, 2> z = {left.start.height_on(n, c), left.end.height_on(n, c)};
  return overlap_of(
      {parameter_along(right, left.start.at(z[0])), parameter_along(right, left.end.at(z[1]))}, z);
}

std::vector<EpipolarOverlap> aligned_overlaps(const SearchedSegment& left,
                                              const Segment2& right,
                                              const std::array<double, 2>& height_range_m,
                                              double tolerance_px,
                                              double step_px) {
  std::vector<EpipolarOverlap> overlaps;
  const Eigen::Vector2d& e = left.epipolar_direction;
  const bool same_way = e.dot(right.end - right.start) * e.dot(left.end.at(height_range_m[0]) -
                                                               left.start.at(height_range_m[0])) >
                        0.0;
  const Eigen::Vector2d& counterpart_of_start = same_way ? right.start : right.end;
  const Eigen::Vector2d& counterpart_of_end = same_way ? right.end : right.start;
  const auto in_range = [&](double z) { return z >= height_range_m[0] && z <= height_range_m[1]; };
  // The parallaxes at which the segments touch end to end are the limits of those at which they
  // overlap.
  const std::array<double, 4> touching = {
      height_beside(left.start, e, right.start), height_beside(left.start, e, right.end),
      height_beside(left.end, e, right.start), height_beside(left.end, e, right.end)};
  const double low =
      std::max(height_range_m[0], *std::min_element(touching.begin(), touching.end()));
  const double high =
      std::min(height_range_m[1], *std::max_element(touching.begin(), touching.end()));
  const double step_m = step_px / left.px_per_m;
  const int n_steps = high >= low ? static_cast<int>((high - low) / step_m) + 1 : 0;
  for (int step = 0; step < n_steps; ++step) {
    const double z = low + step * step_m;
    const auto overlap = aligned_overlap(left, right, {z, z}, tolerance_px);
    if (overlap && covers_enough(*overlap)) overlaps.push_back(*overlap);
  }
  const std::array<double, 2> inclined = {height_beside(left.start, e, counterpart_of_start),
                                          height_beside(left.end, e, counterpart_of_end)};
  if (in_range(inclined[0]) && in_range(inclined[1])) {
    const auto overlap = aligned_overlap(left, right, inclined, tolerance_px);
    if (overlap) overlaps.push_back(*overlap);
  }
  return overlaps;
}

bool may_share_counterpart(const OverlappedSegment& a, const OverlappedSegment& b) {
  return are_fragments(a.segment, b.segment) && disjoint(a.overlap.on_right, b.overlap.on_right);
}

bool may_be_counterparts_of_one(const OverlappedSegment& a, const OverlappedSegment& b) {
  // The tolerance is tight because rows of windows run parallel to the eave above them, in a wall
  // that is only a few pixels wide in the image.
  constexpr double kTolerance_px = 1.0;
  return !a.overlap.aligned && !b.overlap.aligned &&
         are_fragments(a.segment, b.segment, kTolerance_px) &&
         disjoint(a.overlap.on_left, b.overlap.on_left);
}

}  // namespace ridgeline::reconstruct
