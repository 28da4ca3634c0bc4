// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

// Cells used by several tables.

/// An interval with three decimals, "0.140 - 0.166"; "-" if there is none.
std::string interval_text(const std::optional<Interval>& interval_m);
/// The interval of the RMS, followed by "(too few clusters)" if that makes it unreliable.
std::string interval_text(const Summary& summary);
/// The RMS in metres with the numbers of evaluated lines and of all lines, "0.152 (12/14)"; "-" for
/// nullptr.
std::string rms_text(const Summary* summary);
/// The same for the lines decided by plan and images, followed by that for lines decided by points
/// or place, if any: "0.152 (12/14) + 0.634 (2/14)".
std::string headline_text(const Summary* summary);

/// A row of a table of classes.
struct ClassRow {
  /// "total"; for a class with groups "total plan_images", "total points_place" and "total all".
  std::string name;
  Summary figures;
};

/// The rows of a class, the headline first.
std::vector<ClassRow> rows_of(const Summary& summary);

}  // namespace ridgeline::evaluate
