// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// Two-sided p-value of the signed-rank test (Wilcoxon 1945) that paired differences are symmetric
/// about 0. Zero differences are dropped, ties share their mean rank. For up to 25 differences the
/// p-value is exact, from the distribution over all signs of the observed ranks. For more, the
/// normal approximation with corrections for ties and continuity is used. The p-value is too small
/// if the lines are dependent. Empty if all differences are 0. Throws std::invalid_argument for a
/// non-finite difference.
std::optional<double> wilcoxon_signed_rank_p(std::span<const double> differences);

}  // namespace ridgeline::evaluate
