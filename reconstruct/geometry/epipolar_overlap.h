// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/segment.h"

#include <array>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The part of a left segment whose points correspond to points of a right segment, as parameters
/// from the start (0) to the end (1) of each segment. The correspondence is linear between the ends
/// of this part, neglecting perspective within one segment.
struct EpipolarOverlap {
  std::array<double, 2> on_left{};   ///< ascending
  std::array<double, 2> on_right{};  ///< descending if the right segment runs the opposite way
  std::array<double, 2> height_m{};  ///< heights of the line at these ends, local frame
  /// Whether the segments run along the epipolar line, so that geometry does not determine which
  /// points correspond.
  bool aligned = false;

  [[nodiscard]] double share_of_left() const { return on_left[1] - on_left[0]; }
  [[nodiscard]] double share_of_right() const { return std::abs(on_right[1] - on_right[0]); }
  [[nodiscard]] bool reversed() const { return on_right[1] < on_right[0]; }
  /// Parameter on the right segment of a point of the left one, also outside the overlap.
  [[nodiscard]] double right_of(double on_left_parameter) const;
  /// Height of the line at a parameter of the left segment, also outside the overlap.
  [[nodiscard]] double height_at(double on_left_parameter) const;
};

/// A left segment prepared for the search of its counterparts.
struct SearchedSegment {
  Segment2 segment;
  Stretch start, end;                  ///< possible positions of its ends in the right image
  Eigen::Vector2d epipolar_direction;  ///< unit, in the right image at mid height, upwards
  double epipolar_angle_rad = 0.0;     ///< angle of the left segment to its epipolar line
  double px_per_m = 0.0;               ///< parallax per metre of height
};

/// Prepares a left segment. std::nullopt if, at its midpoint, the ray is horizontal, has no
/// parallax, or meets the plane of the right projection centre within the height range.
std::optional<SearchedSegment> searched_segment(const StereoSearch& search,
                                                const Segment2& left_segment);

/// Whether a segment of the pair is so close to the epipolar direction in its image that geometry
/// cannot transfer the end points.
bool is_near_aligned(const SearchedSegment& left, const Segment2& right, double min_angle_rad);

/// Overlap of two segments that are not near-aligned, found by intersecting the epipolar lines of
/// the left end points with the right line. std::nullopt if they do not overlap.
std::optional<EpipolarOverlap> epipolar_overlap(const SearchedSegment& left, const Segment2& right);

/// The possible overlaps of two near-aligned segments, which must lie within `tolerance_px` of each
/// other's epipolar band. The first ones assume a horizontal line at each parallax, in steps of
/// about `step_px`, at which half of the shorter segment is covered. The last one assumes the
/// inclined line for which both ends correspond. Empty if the segments cannot correspond.
std::vector<EpipolarOverlap> aligned_overlaps(const SearchedSegment& left,
                                              const Segment2& right,
                                              const std::array<double, 2>& height_range_m,
                                              double tolerance_px,
                                              double step_px);

/// A segment and its overlap with a segment of the other image.
struct OverlappedSegment {
  const Segment2& segment;
  const EpipolarOverlap& overlap;
};

/// Whether two left segments may have the same counterpart. They may if they are fragments of one
/// edge and correspond to different parts of the counterpart.
bool may_share_counterpart(const OverlappedSegment& a, const OverlappedSegment& b);

/// Whether two right segments may be counterparts of the same left one. They may if they are
/// fragments of one edge to within a pixel and correspond to different parts of the left segment.
/// Near-aligned segments never may, because their overlaps are inferred from appearance.
bool may_be_counterparts_of_one(const OverlappedSegment& a, const OverlappedSegment& b);

}  // namespace ridgeline::reconstruct
