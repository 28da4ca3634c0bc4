// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

// Planes of several lines are one if they were fitted to the same points. The lines are taken in
// the order of their places, so that nothing depends on the order of a file.

/// Fills JudgingPlane::points of judged lines from JudgedResult::inlier_keys. Lines are numbered as
/// the results are. A point that several planes have counts for the first one.
void find_shared_points(std::span<JudgedResult> results);

/// Fills JudgingPlane::id from JudgingPlane::points: a plane is the earlier one with which it
/// shares most of its points, if these are a good part of all, and else a new one. Ids count
/// from 1.
/// @param lines  by their number; null for a line that is not known, whose points count as nobody's
/// Throws std::invalid_argument for points of a plane that is not there or not earlier.
void identify_planes(std::span<LineEvaluation* const> lines);

}  // namespace ridgeline::evaluate
