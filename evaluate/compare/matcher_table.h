// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"

#include <cstddef>
#include <span>
#include <string>

namespace ridgeline::evaluate {

/// What a run with one setting of the matching gave on a patch, or on all of them. Sums, so that
/// patches can be pooled.
struct MatcherFigures {
  std::string patch;
  std::string run;      ///< its folder
  std::string matcher;  ///< "pairwise", "chio", "both"

  MatchCounts counts;         ///< of Table 1; all 0 without reference matches
  std::size_t n_matches = 0;  ///< all, also those the reference says nothing of
  std::size_t n_alone = 0;    ///< matches that no other run has; with reference matches, right ones
  std::size_t n_alone_false = 0;

  std::size_t n_lines = 0, n_evaluated = 0;  ///< against LIDAR
  double sum_squares_m2 = 0.0;               ///< of their distances
  std::size_t n_true = 0;                    ///< on true lines
  double true_sum_squares_m2 = 0.0;
  double n_true_gross = 0.0;
  std::size_t n_roof_lines = 0, n_roof_lines_found = 0;  ///< of true lines but those on the ground

  /// Adds the sums of another patch.
  MatcherFigures& operator+=(const MatcherFigures& other);
};

/// A row per patch and run, in the order given, then one per run over all patches if there are
/// several. Table 1, what each finds that the others miss, accuracy and coverage.
std::string to_markdown(std::span<const MatcherFigures> rows);
std::string to_terminal(std::span<const MatcherFigures> rows);  ///< the same in aligned columns

/// {"rows": [{patch, run, matcher, correct, false, missed, correctness, ...}]}, pooled ones last.
std::string to_json(std::span<const MatcherFigures> rows);

}  // namespace ridgeline::evaluate
