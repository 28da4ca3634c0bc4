// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/wilcoxon.h"

#include "evaluate/probability.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr std::size_t kMaxExact = 25;

struct SignedRanks {
  /// Ranks of |difference| in ascending order, doubled: mean ranks of ties are then whole numbers.
  std::vector<std::size_t> doubled_ranks;
  std::size_t doubled_positive = 0;  ///< twice the rank sum of the positive differences
  double tie_term = 0.0;             ///< sum of t^3 - t over groups of t ties
};

SignedRanks signed_ranks(std::vector<double> differences) {
  std::sort(differences.begin(), differences.end(),
            [](double a, double b) { return std::abs(a) < std::abs(b); });
  SignedRanks result;
  for (std::size_t begin = 0; begin < differences.size();) {
    std::size_t end = begin + 1;
    while (end < differences.size() && std::abs(differences[end]) == std::abs(differences[begin])) {
      ++end;
    }
    const std::size_t doubled_rank = begin + 1 + end;  // ranks begin + 1 .. end
    for (std::size_t i = begin; i < end; ++i) {
      result.doubled_ranks.push_back(doubled_rank);
      if (differences[i] > 0.0) result.doubled_positive += doubled_rank;
    }
    const auto t = static_cast<double>(end - begin);
    result.tie_term += t * t * t - t;
    begin = end;
  }
  return result;
}

double exact_p(const SignedRanks& ranks) {
  const std::size_t largest =
      std::accumulate(ranks.doubled_ranks.begin(), ranks.doubled_ranks.end(), std::size_t{0});
  std::vector<double> probability(largest + 1, 0.0);  // of each doubled rank sum
  probability[0] = 1.0;
  for (const std::size_t rank : ranks.doubled_ranks) {
    for (std::size_t s = largest + 1; s-- > 0;) {
      probability[s] = 0.5 * (probability[s] + (s >= rank ? probability[s - rank] : 0.0));
    }
  }
  const std::size_t smaller_tail =
      std::min(ranks.doubled_positive, largest - ranks.doubled_positive);
  const auto end = probability.begin() + static_cast<std::ptrdiff_t>(smaller_tail) + 1;
  return std::min(1.0, 2.0 * std::accumulate(probability.begin(), end, 0.0));
}

double approximate_p(const SignedRanks& ranks) {
  const auto n = static_cast<double>(ranks.doubled_ranks.size());
  const double mean = n * (n + 1.0) / 4.0;
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ranks.tie_term / 48.0;
  const double deviation = std::abs(0.5 * static_cast<double>(ranks.doubled_positive) - mean);
  const double z = std::max(0.0, deviation - 0.5) / std::sqrt(variance);
  return 2.0 * normal_tail(z);
}

}  // namespace

std::optional<double> wilcoxon_signed_rank_p(std::span<const double> differences) {
  std::vector<double> nonzero;
  for (const double d : differences) {
    check(std::isfinite(d), "wilcoxon_signed_rank_p: difference ", d, ", must be finite");
    if (d != 0.0) nonzero.push_back(d);
  }
  if (nonzero.empty()) return std::nullopt;
  const std::size_t n = nonzero.size();
  const SignedRanks ranks = signed_ranks(std::move(nonzero));
  return n <= kMaxExact ? exact_p(ranks) : approximate_p(ranks);
}

}  // namespace ridgeline::evaluate
