// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A shift with its 95 % intervals: "x 0.301 +- 0.020 m, y -0.006 +- 0.022 m, z -0.002 +- 0.006 m".
/// Axes that the planes do not determine are named. If the planes determine another direction
/// instead, the shift along that direction is given.
std::string shift_text(const ConstantShift& shift);

/// Sentences about the shifts between lines and LIDAR planes: significant shifts, removed shifts
/// and, with `apply_shift`, that there was none to remove.
std::vector<std::string> shift_messages(std::span<const Evaluation> evaluations, bool apply_shift);

/// One sentence for lines that were moved before they were judged; "" for others.
std::string moved_note(const Evaluation& evaluation);

/// The non-empty moved_note() sentences of all evaluations.
std::vector<std::string> moved_notes(std::span<const Evaluation> evaluations);

}  // namespace ridgeline::evaluate
