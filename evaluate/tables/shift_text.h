// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A shift with its 95 % intervals: "x 0.301 +- 0.020 m, y -0.006 +- 0.022 m, z -0.002 +- 0.006 m".
/// Axes that the planes do not tell are named. If they tell another direction instead, the shift
/// along it is given.
std::string shift_text(const ConstantShift& shift);

/// Sentences on the shifts that lines have against the LIDAR planes: those that are significant,
/// those that were taken away, and, if that was asked for (`apply_shift`), that there was none to
/// take away.
std::vector<std::string> shift_messages(std::span<const Evaluation> evaluations, bool apply_shift);

/// One sentence for lines that were moved before they were judged; "" for others.
std::string moved_note(const Evaluation& evaluation);

/// The sentences of moved_note() of all evaluations, without the empty ones.
std::vector<std::string> moved_notes(std::span<const Evaluation> evaluations);

}  // namespace ridgeline::evaluate
