// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "reconstruct/views/conditioned_view.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// A segment with the covariance of (start, end).
struct UncertainSegment3 {
  Segment3 segment;
  Matrix6d cov;
};

/// The part of a 3D line seen as an image segment, in the conditioned frame: each endpoint is where
/// the line meets the plane of the image line through the segment's end, normal to the segment. Its
/// covariance has the line's share and, along the line, that of the image endpoint.
/// Empty if an endpoint is at infinity or behind one of `views`.
std::optional<UncertainSegment3> endpoints(const UncertainLine3& line,
                                           const ConditionedView& view,
                                           const ObservedLine& observed,
                                           std::span<const ConditionedView> views);

/// Larger height sigma of the two ends.
double largest_sigma_z_m(const Matrix6d& cov_m2);

/// Replaces the result's geometry by the part of the line that is seen between the ends of its left
/// segment, or of a not_aligned line whose end is less certain than that (height), where the right ones are more certain,
/// between these; false, and nothing is
/// changed, if a camera does not see it.
bool assign_geometry(const StereoViews& stereo,
                     const ObservedPair& seen,
                     const UncertainLine3& estimate,
                     double max_end_sigma_m,
                     ReconstructedLine& result);

}  // namespace ridgeline::reconstruct
