// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <array>
#include <cstddef>
#include <span>

namespace ridgeline::apps {

/// The heights of a patch that states `auto`.
struct AreaHeights {
  std::array<double, 2> range_m{};  ///< with margins
  std::size_t n = 0;                ///< points or cells that they are of
};

/// Added to both sides of the heights, m.
constexpr double kHeightMargin_m = 10.0;

/// The lowest and the highest height; groups that hold fewer than a thousandth of the heights and
/// are more than kHeightMargin_m from all others are left out. `heights_m` must not be empty.
std::array<double, 2> height_limits_m(std::span<const double> heights_m);

/// See complete_patch().
AreaHeights area_heights(const io::PatchFile& patch);

}  // namespace ridgeline::apps
