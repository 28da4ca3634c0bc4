// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

// Planes of several lines are the same if they were fitted to the same points. The lines are
// processed in the order of their positions, so that nothing depends on their order in a file.

/// Fills in JudgingPlane::points of judged lines from JudgedResult::inlier_keys. Lines are numbered
/// like the results. A point common to several planes is attributed to the first of them.
void find_shared_points(std::span<JudgedResult> results);

/// Fills in JudgingPlane::id from JudgingPlane::points: a plane gets the id of the earlier plane
/// with which it shares most of its points if these are a large enough part of all its points, and
/// otherwise a new id. Ids start at 1.
/// @param lines  by their number; null for an unknown line, whose points are ignored
/// Throws std::invalid_argument if a plane shares points with one that does not exist or is not
/// earlier.
void identify_planes(std::span<LineEvaluation* const> lines);

}  // namespace ridgeline::evaluate
