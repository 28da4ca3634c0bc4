// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Judges every line, in parallel; the i-th result belongs to the i-th line and depends neither on
/// the number of threads nor on the other lines. A line with the id of an earlier one gets the
/// status `duplicate_id`. Planes that share their points get the same id across all lines, because
/// lines judged by the same plane are not independent.
/// Throws std::invalid_argument for an option out of its range.
std::vector<JudgedResult> judge_lines(const PointSearch& search,
                                      std::span<const JudgedLine> lines,
                                      const JudgeOptions& options);

}  // namespace ridgeline::evaluate
