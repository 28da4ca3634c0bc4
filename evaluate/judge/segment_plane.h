// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

namespace ridgeline {

/// Orthogonal distance of a segment to a plane, in the unit of the coordinates.
struct SegmentPlaneDistance {
  double start = 0.0;     ///< signed, positive on the side of the normal
  double end = 0.0;       ///< signed
  double mean_abs = 0.0;  ///< mean of |distance| over all points of the segment (Ok et al. 2011)
  double mean = 0.0;      ///< signed mean: shows a bias, but not a tilt
  double rms = 0.0;       ///< root of the mean square over all points
  double max_abs = 0.0;   ///< always attained at an endpoint
};

/// The signed distance is linear along the segment, s(t) = (1 - t) a + t b, hence exactly
///   mean |s| = |a + b| / 2 for equal signs, else (a^2 + b^2) / (2 (|a| + |b|)),
///   mean s = (a + b) / 2,   mean s^2 = (a^2 + a b + b^2) / 3.
/// A segment of zero length is treated as a point.
/// Throws std::invalid_argument unless the plane's normal has unit length.
SegmentPlaneDistance orthogonal_distance(const Segment3& segment, const Plane3& plane);

}  // namespace ridgeline
