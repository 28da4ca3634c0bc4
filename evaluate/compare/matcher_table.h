// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"

#include <cstddef>
#include <span>
#include <string>

namespace ridgeline::evaluate {

/// The figures of a run with one matcher on one patch or on all patches. They are sums, so that
/// patches can be pooled.
struct MatcherFigures {
  std::string patch;
  std::string run;      ///< the folder of the run
  std::string matcher;  ///< "pairwise" or "chio"

  MatchCounts counts;         ///< for Table 1; all 0 without reference matches
  std::size_t n_matches = 0;  ///< all matches, including those that the reference cannot judge
  std::size_t n_alone = 0;  ///< matches that no other run has; with a reference, only correct ones
  std::size_t n_alone_false = 0;

  std::size_t n_lines = 0, n_evaluated = 0;  ///< all lines, and those judged by LIDAR planes
  double sum_squares_m2 = 0.0;               ///< of the distances of the judged lines
  std::size_t n_true = 0;                    ///< lines that lie on a true line
  double true_sum_squares_m2 = 0.0;
  double n_true_gross = 0.0;
  std::size_t n_roof_lines = 0, n_roof_lines_found = 0;  ///< true lines not on the ground

  /// Adds the sums of another patch.
  MatcherFigures& operator+=(const MatcherFigures& other);
};

/// A table with a row per patch and run, in the given order, then, for several patches, a row per
/// run over all patches. It contains the figures of Table 1, the matches that only one run finds,
/// accuracy and coverage.
std::string to_markdown(std::span<const MatcherFigures> rows);
std::string to_terminal(
    std::span<const MatcherFigures> rows);  ///< the same table in aligned columns

/// {"rows": [{patch, run, matcher, correct, false, missed, correctness, ...}]}, pooled rows last.
std::string to_json(std::span<const MatcherFigures> rows);

}  // namespace ridgeline::evaluate
