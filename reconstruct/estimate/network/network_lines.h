// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/line_support.h"
#include "reconstruct/estimate/reconstruct_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line by `joint` with what it rests on beside its planes.
struct JointLine {
  ReconstructedLine line;
  LineSupport support;
};

/// Method::kNetwork: adjust_network() from the results of `joint`, which say what aligned lines rest on.
/// Lines that have no geometry, and those without an accepted meeting, stay as they are.
/// @param lines     with covariances of the centroid form, whatever `joint` has used
/// @param by_match  of each match its line, or its parts
void adjust_together(const StereoLines& lines,
                     std::span<const PairConnection> connections,
                     const ReconstructOptions& options,
                     std::vector<std::vector<JointLine>>& by_match);

}  // namespace ridgeline::reconstruct
