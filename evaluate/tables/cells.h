// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"

#include <optional>
#include <string>

namespace ridgeline::evaluate {

// Cells that several tables have.

/// An interval with three decimals, "0.140 - 0.166"; "-" if there is none.
std::string interval_text(const std::optional<Interval>& interval_m);
/// The interval of the RMS, with "(too few clusters)" behind it if that makes it unreliable.
std::string interval_text(const Summary& summary);
/// The RMS in metres with the numbers of evaluated and of all lines, "0.152 (12/14)"; "-" for nullptr.
std::string rms_text(const Summary* summary);

}  // namespace ridgeline::evaluate
