// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/extract/options.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Where a straight run of edge pixels is better described by several lines: eaves of a terrace that
/// steps down a slope, or an edge and the shadow that continues it, follow each other within a
/// fraction of a pixel, which is decimetres in height. A run is cut where two lines fit it better
/// than one by more than min_bend_px (root mean square) and by more than the scatter explains, and
/// the parts again; each is min_length_px long at least.
/// @return  where the parts begin and the last one ends: ascending, from 0 to points.size()
std::vector<std::size_t> bends(std::span<const Eigen::Vector2d> points,
                               const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
