// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace ridgeline::reconstruct {

/// Position of the vertex of the parabola through values at -1, 0 and 1, clamped to half a step
/// from the middle; 0 if the parabola has no maximum.
template <typename T>
T vertex_of_parabola(T before, T middle, T after) {
  const T curvature = 2 * middle - before - after;
  if (!(curvature > 0)) return 0;
  return std::clamp((after - before) / (2 * curvature), T(-0.5), T(0.5));
}

}  // namespace ridgeline::reconstruct
