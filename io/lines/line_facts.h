// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/coordinate_steps.h"
#include "io/lines/line_set.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// What a line file holds, for `ridgeline info`. Its format, CRS and warnings stand in the LineSet.
struct LineFacts {
  std::size_t n_lines = 0;
  std::size_t n_polylines = 0;  ///< polylines or tracks that several of the lines are parts of
  std::size_t n_non_finite = 0;
  double total_length = 0.0;            ///< length of the finite lines, file units
  Eigen::AlignedBox3d bounds;           ///< box of the finite lines, file units; empty without any
  std::vector<std::string> attributes;  ///< names of those that at least one line has
};

LineFacts line_facts(const LineSet& set);

/// Steps of the coordinates of all lines, see CoordinateSteps. `unit_m`: metres per unit by axis.
CoordinateSteps steps_of(const LineSet& set, const Eigen::Vector3d& unit_m);

}  // namespace ridgeline::io
