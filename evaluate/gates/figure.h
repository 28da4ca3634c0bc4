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

/// What a gate compares: a figure from a cell of Table 2 or a row of Table 1.
struct Figure {
  std::string patch, method;
  std::string line_class;  ///< empty for a figure of matching
  std::optional<double> value;
  std::optional<Interval> ci95;
  std::size_t n_clusters = 0;  ///< of the interval; 0 if it is not clustered
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  std::string why_missing;  ///< a sentence, empty if there is a value
};

/// The figures to which a gate applies, for `line_class` instead of the gate's own class. There is
/// at least one for the patch named by the gate, or for each patch; it has no value if the results
/// do not contain the figure. A gate without a method applies to the main result of the run: for a
/// reconstructed patch, the last of direct, joint and network that was run; for an evaluation of
/// line files, every file; for matching figures, the matcher that was run.
std::vector<Figure> figures_of(const Gate& gate,
                               const std::string& line_class,
                               const ResultFolder& folder);

}  // namespace ridgeline::evaluate
