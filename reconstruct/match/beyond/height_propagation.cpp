// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/height_propagation.h"

#include <algorithm>

namespace ridgeline::reconstruct {

std::vector<Correspondence> propagate_heights(const StereoPair& pair,
                                              std::span<const Correspondence> given,
                                              const ChioOptions& chio,
                                              const CandidateOptions& candidates,
                                              const ChioExtensions& beyond,
                                              const MatchExtensionOptions& options) {
  if (given.empty()) return {};
  ChioOptions propagation = chio;
  // Heights of lines that are only nearby brought more wrong lines than right ones.
  propagation.range_m = 0.0;
  ChioExtensions stricter = beyond;
  if (stricter.by_look) {
    double& similarity = stricter.by_look->min_similarity;
    similarity = std::max(similarity, options.propagate_min_similarity);
  }
  return matches_of(chio_match(pair, propagation, candidates, stricter, given));
}

}  // namespace ridgeline::reconstruct
