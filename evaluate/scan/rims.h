// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/surroundings.h"

#include <optional>

namespace ridgeline::evaluate {

/// A narrow wall that rises along the border of a roof, such as the parapet of a flat one.
struct Rim {
  double height_m = 0.0;  ///< of its top above the plane of the roof
  double sigma_height_m = 0.0;
  Segment2 outer_uv_m;    ///< its outer edge, in the plane of the roof
  BorderLine outer_line;  ///< in the frame of the border
};

/// The rim along a border: points at one height above the plane, next to most of the border.
std::optional<Rim> find_rim(const ScanRegion& region,
                            const Border& border,
                            const BorderSurroundings& surroundings);

}  // namespace ridgeline::evaluate
