// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// Iterative matching and linking in object space (Chio and Wang 2000, section 4). The thresholds
/// are those of the paper, whose images have a ground pixel of 0.24 m.
struct ChioOptions {
  double max_azimuth_deg = 10.0;
  int min_pieces = 8;
  double height_difference_m = 0.5;  ///< limit in the second to the fourth process
  double range_m = 5.0;              ///< search range of the fourth process; our own value

  static constexpr auto fields() {
    using O = ChioOptions;
    return std::tuple{
        Field{"max_azimuth_deg", &O::max_azimuth_deg, 0.0, 90.0,
              "maximum difference in azimuth of two candidates"},
        Field{"min_pieces", &O::min_pieces, 1, 1000,
              "minimum number of reliable pieces of an initial link"},
        Field{"height_difference_m", &O::height_difference_m, 0.0, 1e3,
              "maximum height difference to a matched neighbour"},
        Field{"range_m", &O::range_m, 0.0, 1e3, "search range for lines near matched ones"}};
  }
};

}  // namespace ridgeline::reconstruct
