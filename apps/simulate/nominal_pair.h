// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "reconstruct/geometry/epipolar.h"

#include <array>

namespace ridgeline::simulate {

/// Two vertical frames over the middle of the scene in the geometry of Ok et al. 2011, section 4:
/// 800 m above ground, GSD 8 cm (f = 10,000 px), base along x with B/H 0.26. Pixel (0, 0) lies at
/// the principal point; world coordinates.
std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene);

/// The lines with their epipolar angle in the nominal pair and the class that follows from it:
/// `aligned` up to 10 degrees, else `not_aligned`.
io::LineSet classed_by_nominal_pair(io::LineSet lines, const Scene& scene);

}  // namespace ridgeline::simulate
