// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
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

}  // namespace ridgeline::reconstruct
