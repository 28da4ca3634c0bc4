// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/scene.h"
#include "io/lines/line_set.h"

#include <span>

namespace ridgeline::simulate {

/// Adds to the true lines of a scene, in order of SyntheticScene::lines, what the views of a block
/// show of them: `n_images`, the number of views that see at least half of the line; `visible_left`
/// and `visible_right`, the largest and the second largest visible share in a view; and the class
/// determined from the views counted in `n_images`. A line with fewer than two such views keeps its
/// class.
io::LineSet seen_in_block(const SyntheticScene& scene,
                          std::span<const AerialView> views,
                          io::LineSet truth);

}  // namespace ridgeline::simulate
