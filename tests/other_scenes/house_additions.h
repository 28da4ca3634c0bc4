// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/roofs.h"

namespace ridgeline::other {

/// What stands before anything is added to a house.
struct HouseBody {
  Wing wing;
  double detailed_side = 1.0;   ///< of the ridge, -1 or 1: where chimney, dormers or modules are
  bool has_cross_wing = false;  ///< on the other side
  bool has_ridge = false;
};

/// An annex with a lean-to or a flat roof, at a longer side of the house if there is room, else at
/// an end, and small dormers; either may be missing.
void add_additions(Solids& solids, const HouseBody& body, bool has_room, RandomStream& random);

}  // namespace ridgeline::other
