// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_region.h"
#include "reconstruct/geometry/segment.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// A line along which two regions meet; local frame.
struct Seam {
  std::array<std::size_t, 2> regions;  ///< ascending
  Segment3 segment;
  double support = 0.0;
  bool is_valley = false;  ///< whether both planes rise from it
};

/// The seams of pairs of regions: where points of both lie within reach of the intersection of
/// their planes. Planes that meet at less than 6 degrees have none.
/// @param pairs  regions that touch each other, ascending
std::vector<Seam> find_seams(std::span<const ScanRegion> regions,
                             std::span<const std::pair<std::size_t, std::size_t>> pairs);

}  // namespace ridgeline::evaluate
