// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "reconstruct/geometry/epipolar.h"

#include <array>

namespace ridgeline::simulate {

/// Projection matrices of two exactly vertical frames with the defaults of FlightOptions: the
/// geometry of Ok et al. 2011, section 4, without errors of the flight.
std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene);

/// The lines with their epipolar angle in a pair and the class that follows from it:
/// `aligned` up to 10 degrees, else `not_aligned`.
io::LineSet classed_by_pair(io::LineSet lines, const std::array<ProjectionMatrix, 2>& pair);

}  // namespace ridgeline::simulate
