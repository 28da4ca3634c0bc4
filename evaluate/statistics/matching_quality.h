// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/interval.h"

#include <cstddef>
#include <optional>

namespace ridgeline::evaluate {

/// Numbers of objects: correct = TP, false = FP, missed = FN.
struct MatchCounts {
  std::size_t n_correct = 0, n_false = 0, n_missed = 0;
};

/// Shares in [0, 1] (Rutzinger et al. 2009), each with its 95 % Wilson interval; empty where the
/// denominator is 0.
struct MatchQuality {
  std::optional<double> correctness;   ///< TP / (TP + FP)
  std::optional<double> completeness;  ///< TP / (TP + FN)
  std::optional<double> quality;       ///< TP / (TP + FP + FN)
  std::optional<Interval> correctness_ci95, completeness_ci95, quality_ci95;
};

MatchQuality match_quality(const MatchCounts& counts);

}  // namespace ridgeline::evaluate
