// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/scene.h"
#include "io/lines/line_set.h"

#include <span>

namespace ridgeline::simulate {

/// The true lines of a scene, in order of SyntheticScene::lines, with what the views of a block
/// show of them: `n_images`, the number of views that see half of the line or more; `visible_left`
/// and `visible_right`, the largest and the second largest share of it that a view sees; and the
/// class by the views that count. A line that fewer than two see keeps its class.
io::LineSet seen_in_block(const SyntheticScene& scene,
                          std::span<const AerialView> views,
                          io::LineSet truth);

}  // namespace ridgeline::simulate
