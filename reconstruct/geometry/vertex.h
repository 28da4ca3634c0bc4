// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline {

/// Offset of the vertex of a parabola through three values at -1, 0 and 1; 0 unless the middle one is the largest.
inline double vertex(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  if (!(curvature < 0.0) || before > middle || after > middle) return 0.0;
  return 0.5 * (before - after) / curvature;
}

}  // namespace ridgeline
