// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Method::kNetwork: adjust_network() from the results of `joint`, which say what aligned lines rest on.
/// Lines that have no geometry stay as they are, and so do those that it cannot adjust, that are hardly
/// determined by it, that have no more accepted meetings than `joint` has points, or whose height `joint`
/// knows better.
/// @param lines     with covariances of the centroid form, whatever `joint` has used
/// @param by_match  of each match its line, or its parts
void adjust_together(const StereoLines& lines,
                     std::span<const PairConnection> connections,
                     const EstimationOptions& options,
                     std::vector<std::vector<JointLine>>& by_match);

}  // namespace ridgeline::reconstruct
