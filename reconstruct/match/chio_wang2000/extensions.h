// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"

#include <optional>

namespace ridgeline::reconstruct {

/// Allowance for the noise of the edge pixels: rates and heights may exceed their limits by it, a
/// slope within its limit may turn a line between the views, and heights are compared where two
/// lines meet (if they do not, by their height ranges).
struct NoiseAllowance {
  double edge_sigma_px = 0.25;  ///< sigma of a single edge pixel across its edge
};

/// Candidates compete by their appearance. A segment stays unmatched if it does not resemble its
/// best candidate, or if another candidate is about as similar.
struct ChoiceByAppearance {
  double min_similarity = 0.3;
  /// Largest ratio of the similarity of the second best candidate to that of the best one.
  double max_similarity_ratio = 0.8;
};

/// Extensions of the matching in object space beyond the paper. If one is empty, its step follows
/// the paper to the letter.
struct ChioExtensions {
  CandidateAppearance change_appearance{};
  std::optional<NoiseAllowance> noise{};
  std::optional<ChoiceByAppearance> by_appearance{};
};

}  // namespace ridgeline::reconstruct
