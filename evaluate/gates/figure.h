// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"
#include "evaluate/tables/result_folder.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// The matcher that Table 1 names for the matches of both together.
inline constexpr std::string_view kCombinedMatches = "both";

/// What a gate compares: a figure of one cell of Table 2, or of one row of Table 1.
struct Figure {
  std::string patch, method;
  std::string line_class;  ///< empty for a figure of matching
  std::optional<double> value;
  std::optional<Interval> ci95;
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  std::string why_missing;  ///< a sentence, empty if there is a value
};

/// The figures that a gate concerns, with `line_class` in place of its own. Never none: of every
/// patch that the gate names, or of each, at least one, without a value where there is none.
/// A gate that names no method concerns what the run is for: of a patch that was reconstructed the
/// last of direct, joint, network that was run, of an evaluation of line files every file; of
/// matchers the matches of both together, else the matcher that was run.
std::vector<Figure> figures_of(const Gate& gate,
                               const std::string& line_class,
                               const ResultFolder& folder);

}  // namespace ridgeline::evaluate
