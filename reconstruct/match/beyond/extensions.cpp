// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/extensions.h"

#include "reconstruct/match/beyond/hidden_walls/hidden_strips.h"
#include "reconstruct/match/beyond/hidden_walls/side_past_wall.h"
#include "reconstruct/match/beyond/matched_radiometry.h"
#include "reconstruct/match/beyond/surface_candidates.h"

#include <array>

namespace ridgeline::reconstruct {

MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates,
                                 const Surface* surface) {
  MatchExtensions beyond;
  if (options.hidden_walls) beyond.appearance = appearance_past_wall;
  if (options.matched_radiometry) {
    beyond.radiometry = [candidates, appearance = beyond.appearance](const SearchedPair& pair,
                                                                     const Radiometry& first) {
      return matched_radiometry(pair, first, candidates, appearance);
    };
  }
  beyond.candidates = [options, surface](const SearchedPair& pair, const Radiometry& radiometry,
                                         Candidates& found) {
    if (options.hidden_walls) compare_across_hidden_strips(pair, radiometry, found);
    if (options.surface && surface != nullptr)
      weigh_by_surface(*surface, ideal_segments(pair.left), found);
  };
  return beyond;
}

ChioExtensions chio_extensions(const ChioExtensionOptions& options,
                               const CandidateAppearance& change_appearance) {
  ChioExtensions beyond{change_appearance};
  if (options.allow_noise) beyond.noise = NoiseAllowance{};
  if (options.by_appearance) beyond.by_appearance = ChoiceByAppearance{options.min_similarity};
  return beyond;
}

}  // namespace ridgeline::reconstruct
