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

/// What a gate compares: a figure of one cell of Table 2, or of one row of Table 1.
struct Figure {
  std::string patch, method;
  std::string line_class;  ///< empty for a figure of matching
  std::optional<double> value;
  std::optional<Interval> ci95;
  std::size_t n_clusters = 0;  ///< of the interval; 0 if it is not of clusters
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  std::string why_missing;  ///< a sentence, empty if there is a value
};

/// The figures that a gate concerns, with `line_class` in place of the gate's own class. For the
/// patch that the gate names, or for each patch, there is at least one; it has no value if the
/// results have no such figure. A gate that names no method concerns what the run is for. For a
/// reconstructed patch that is the last of direct, joint and network that was run; for an
/// evaluation of line files it is every file; for figures of matching it is the matcher that was
/// run.
std::vector<Figure> figures_of(const Gate& gate,
                               const std::string& line_class,
                               const ResultFolder& folder);

}  // namespace ridgeline::evaluate
