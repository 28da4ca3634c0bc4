// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// A segment with the covariance of (start, end).
struct UncertainSegment3 {
  Segment3 segment;
  Matrix6d cov;
};

/// The part of a 3D line seen as an image segment, in the conditioned frame: each endpoint is where
/// the line meets the plane of the image line through the segment's end, normal to the segment. The
/// covariance of an endpoint is the sum of the contributions of the line and, along the line, of
/// the image endpoint.
std::optional<UncertainSegment3> endpoints(const UncertainLine3& line,
                                           const ConditionedView& view,
                                           const ObservedLine& observed,
                                           std::span<const ConditionedView> views);

/// The larger height sigma of the two ends of a segment.
double largest_sigma_z_m(const Matrix6d& cov_m2);

/// Sets the geometry of the result to the part of the line that its views show:
/// - to the farthest ends that two views show, each the median of the views that agree within 3
///   sigma;
/// - between the ends of the base segment if no part is common to two views, and, of two segments,
///   if the line is a part of a cut track or TrackedLines::common_part is not set.
/// Returns false and changes nothing if a camera does not see the line between its base ends.
bool assign_geometry(const TrackedLines& lines,
                     const ObservedTrack& track,
                     const UncertainLine3& estimate,
                     ReconstructedLine& result);

}  // namespace ridgeline::reconstruct
