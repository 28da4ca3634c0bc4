// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/views/candidates.h"
#include "reconstruct/views/match_view.h"

#include <functional>
#include <vector>

namespace ridgeline::reconstruct {

/// Where what goes beyond the paper enters the matching. Each may be empty.
struct MatchExtensions {
  /// A better radiometry than the first one, which the flanks of all segments give.
  std::function<Radiometry(const SearchedPair& pair, const Radiometry& first)> radiometry;
  CandidateLook look;
  /// Changes the candidates, best first, once all of them are known.
  std::function<void(const SearchedPair& pair,
                     const Radiometry& radiometry,
                     std::vector<std::vector<Candidate>>& candidates)>
      candidates;
};

}  // namespace ridgeline::reconstruct
