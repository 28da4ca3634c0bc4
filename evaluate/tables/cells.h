// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

// Tables in Markdown, and cells that several tables have.

/// The head of a table with its rule. A column whose name ends in a colon is flush right: "RMS:".
std::string markdown_head(const std::vector<std::string>& columns);

/// A row of a table. Text that is not the program's own must be escaped; see escape_markdown().
template <typename... Cells>
std::string markdown_row(const Cells&... cells) {
  std::string row = "|";
  ((row += fmt::format(" {} |", cells)), ...);
  return row + "\n";
}

/// "0.140 - 0.166".
std::string interval_text(const std::optional<Interval>& interval_m);
/// That of the RMS; with a word where its clusters are too few.
std::string interval_text(const Summary& summary);
/// "0.152 (12/14)": RMS, evaluated lines of all. `summary` may be nullptr: no such figure.
std::string rms_text(const Summary* summary);

}  // namespace ridgeline::evaluate
