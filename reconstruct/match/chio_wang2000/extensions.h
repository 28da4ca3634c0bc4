// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"

#include <optional>

namespace ridgeline::reconstruct {

/// The noise of the edge pixels is allowed for: rates and heights may exceed their limits by it, a
/// slope within its limit may turn a line between the views, and heights are compared where two
/// lines meet or come nearest.
struct NoiseAllowance {
  double edge_sigma_px = 0.25;  ///< sigma of a single edge pixel across its edge
};

/// Candidates compete by their appearance. A segment stays unmatched if it does not look like its
/// best candidate, or if another candidate looks about as good.
struct ChoiceByAppearance {
  double min_similarity = 0.3;
  /// Largest ratio of the similarities of the next candidate and the best one.
  double max_similarity_ratio = 0.8;
};

/// The extensions beyond the paper that the matching in object space takes. Each may be empty: then
/// its step follows the paper to the letter.
struct ChioExtensions {
  CandidateAppearance change_appearance{};
  std::optional<NoiseAllowance> noise{};
  std::optional<ChoiceByAppearance> by_appearance{};
};

}  // namespace ridgeline::reconstruct
