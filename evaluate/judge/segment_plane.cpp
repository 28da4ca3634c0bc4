// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/segment_plane.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>

namespace ridgeline {

SegmentPlaneDistance orthogonal_distance(const Segment3& segment, const Plane3& plane) {
  constexpr double kUnitTolerance = 1e-9;  // scales a distance of 1 km by at most 1 um
  const double excess = plane.normal().norm() - 1.0;
  check(std::abs(excess) <= kUnitTolerance, "orthogonal_distance: |normal| - 1 = ", excess,
        ", must be 0");

  const double a = plane.signedDistance(segment.start);
  const double b = plane.signedDistance(segment.end);
  const bool crosses = a * b < 0.0;
  return {.start = a,
          .end = b,
          .mean_abs = crosses ? (a * a + b * b) / (2.0 * (std::abs(a) + std::abs(b)))
                              : std::abs(a + b) / 2.0,
          .mean = (a + b) / 2.0,
          .rms = std::sqrt(std::max(0.0, (a * a + a * b + b * b) / 3.0)),
          .max_abs = std::max(std::abs(a), std::abs(b))};
}

}  // namespace ridgeline
