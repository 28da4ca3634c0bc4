// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/options.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Cuts a straight run of edge pixels where several lines describe it better. Eaves of a terrace
/// that steps down a slope, or an edge and the shadow that continues it, are aligned to within a
/// fraction of a pixel although their heights differ by decimetres. A run is cut where two lines
/// fit it better than one by more than 0.2 px (root mean square) and by more than the scatter
/// explains. The parts are cut again in the same way; each is at least min_length_px long.
/// @return  the starts of the parts and the end of the last one: ascending, from 0 to points.size()
std::vector<std::size_t> bends(std::span<const Eigen::Vector2d> points,
                               const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
