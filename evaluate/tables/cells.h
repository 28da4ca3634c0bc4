// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"

#include <optional>
#include <string>

namespace ridgeline::evaluate {

// Cells that several tables have.

/// "0.140 - 0.166".
std::string interval_text(const std::optional<Interval>& interval_m);
/// That of the RMS; with a word where its clusters are too few.
std::string interval_text(const Summary& summary);
/// "0.152 (12/14)": RMS, evaluated lines of all. `summary` may be nullptr: no such figure.
std::string rms_text(const Summary* summary);

}  // namespace ridgeline::evaluate
