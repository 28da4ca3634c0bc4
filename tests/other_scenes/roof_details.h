// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/roofs.h"

namespace ridgeline::other {

struct Dormer {
  double width_m = 2.8;  ///< of its roof, overhang included
  double front_height_m = 1.25;
  double overhang_m = 0.2;
};

/// A gabled dormer on the plane of `wing` at y < 0 or y > 0 (`side` -1 or 1), `along_m` from the
/// middle of the ridge. Nothing if the roof is too low for one.
void add_dormer(
    Solids& solids, const Wing& wing, double side, double along_m, const Dormer& dormer = {});

/// On the same plane: a window of 0.8 m x 1.2 m, `up_m` above the eave along the slope.
void add_roof_window(Solids& solids, const Wing& wing, double side, double along_m, double up_m);

/// Rows of solar modules, as many as the plane takes.
void add_panels(Solids& solids, const Wing& wing, double side, std::uint64_t seed);

/// Beside the ridge.
void add_chimney(Solids& solids, const Wing& wing, RandomStream& random);

}  // namespace ridgeline::other
