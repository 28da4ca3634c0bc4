// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/coordinate_steps.h"
#include "io/lines/line_set.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Statistics of a line file, for `ridgeline info`. Its format, CRS and warnings are in the
/// LineSet.
struct LineFacts {
  std::size_t n_lines = 0;
  std::size_t n_polylines = 0;  ///< polylines or tracks that consist of several of the lines
  std::size_t n_non_finite = 0;
  double total_length = 0.0;   ///< length of the finite lines, file units
  Eigen::AlignedBox3d bounds;  ///< box of the finite lines, file units; empty if there are none
  std::vector<std::string> attributes;  ///< names of the attributes that at least one line has
};

LineFacts line_facts(const LineSet& set);

/// Coordinate steps of all lines, see CoordinateSteps. `unit_m`: metres per unit by axis.
CoordinateSteps steps_of(const LineSet& set, const Eigen::Vector3d& unit_m);

}  // namespace ridgeline::io
