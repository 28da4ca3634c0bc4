// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/matching_quality.h"

namespace ridgeline::evaluate {
namespace {

std::optional<double> ratio(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

MatchQuality match_quality(const MatchCounts& counts) {
  const std::size_t n_found = counts.n_correct + counts.n_false;
  const std::size_t n_true = counts.n_correct + counts.n_missed;
  const std::size_t n_all = n_found + counts.n_missed;
  return {.correctness = ratio(counts.n_correct, n_found),
          .completeness = ratio(counts.n_correct, n_true),
          .quality = ratio(counts.n_correct, n_all),
          .correctness_ci95 = wilson_interval(counts.n_correct, n_found),
          .completeness_ci95 = wilson_interval(counts.n_correct, n_true),
          .quality_ci95 = wilson_interval(counts.n_correct, n_all)};
}

}  // namespace ridgeline::evaluate
