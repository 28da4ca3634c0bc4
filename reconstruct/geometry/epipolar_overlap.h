// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/segment.h"

#include <array>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The part of a left segment whose points correspond to points of a right segment, as parameters
/// from start (0) to end (1) of each. The correspondence is linear between its ends, which neglects
/// the perspective within one segment.
struct EpipolarOverlap {
  std::array<double, 2> on_left{};   ///< ascending
  std::array<double, 2> on_right{};  ///< descending if the right segment runs the other way
  std::array<double, 2> height_m{};  ///< heights of the line at these ends, local frame
  /// Whether the segments run along the epipolar line, so that geometry alone does not tell what
  /// corresponds.
  bool aligned = false;

  [[nodiscard]] double share_of_left() const { return on_left[1] - on_left[0]; }
  [[nodiscard]] double share_of_right() const { return std::abs(on_right[1] - on_right[0]); }
  [[nodiscard]] bool reversed() const { return on_right[1] < on_right[0]; }
  /// Parameter on the right segment of a point of the left one, also outside of the overlap.
  [[nodiscard]] double right_of(double on_left_parameter) const;
  /// Height of the line at a parameter of the left segment, also outside of the overlap.
  [[nodiscard]] double height_at(double on_left_parameter) const;
};

/// A left segment prepared for the search of its counterparts.
struct SearchedSegment {
  Segment2 segment;
  Stretch start, end;                  ///< where its ends may lie in the right image
  Eigen::Vector2d epipolar_direction;  ///< unit, in the right image at mid height, upwards
  double epipolar_angle_rad = 0.0;     ///< angle of the left segment to its epipolar line
  double px_per_m = 0.0;               ///< parallax per metre of height
};

/// Prepares a left segment. Nothing if its rays do not meet the range of heights in front of the
/// cameras.
std::optional<SearchedSegment> searched_segment(const StereoSearch& search,
                                                const Segment2& left_segment);

/// Whether a pair of segments is too close to the epipolar direction for its end points to be
/// transferred by geometry, in either image.
bool is_near_aligned(const SearchedSegment& left, const Segment2& right, double min_angle_rad);

/// Overlap of two segments that are not near-aligned: the epipolar lines of the left end points are
/// cut with the right line. Nothing if they have no overlap.
std::optional<EpipolarOverlap> epipolar_overlap(const SearchedSegment& left, const Segment2& right);

/// The possible overlaps of two near-aligned segments, which must lie within `tolerance_px` of each
/// other's epipolar band. The first ones take the line as horizontal, for every parallax, in steps
/// of about `step_px`, at which half of the shorter segment is covered. The last one is the
/// inclined line that lets both ends correspond. Empty if the segments cannot correspond.
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
/// edge and each has a part of the counterpart of its own.
bool may_share_counterpart(const OverlappedSegment& a, const OverlappedSegment& b);

/// Whether two right segments may be counterparts of the same left one. They may if they are
/// fragments of one edge to a pixel and each has a part of the left segment of its own.
/// Near-aligned segments never may, because their parts are guessed from their appearance.
bool may_be_counterparts_of_one(const OverlappedSegment& a, const OverlappedSegment& b);

}  // namespace ridgeline::reconstruct
