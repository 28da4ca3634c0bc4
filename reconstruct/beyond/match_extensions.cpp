// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/match_extensions.h"

#include "reconstruct/beyond/close_edges/close_lines.h"
#include "reconstruct/beyond/hidden_walls/hidden_strips.h"
#include "reconstruct/beyond/hidden_walls/side_past_wall.h"
#include "reconstruct/beyond/matched_radiometry/matched_radiometry.h"

namespace ridgeline::reconstruct {

MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates) {
  MatchExtensions beyond;
  if (options.hidden_walls) beyond.look = look_past_wall;
  if (options.matched_radiometry) {
    beyond.radiometry = [candidates, look = beyond.look](const SearchedPair& pair,
                                                         const Radiometry& first) {
      return matched_radiometry(pair, first, candidates, look);
    };
  }
  if (!options.close_lines && !options.hidden_walls) return beyond;
  beyond.candidates = [options](const SearchedPair& pair, const Radiometry& radiometry,
                                std::vector<std::vector<Candidate>>& found) {
    const std::array<CloseLines, 2> close{close_lines(ideal_segments(pair.left)),
                                          close_lines(ideal_segments(pair.right))};
    if (options.close_lines) keep_order_of_close_lines(pair, close, found);
    if (options.hidden_walls) compare_across_hidden_strips(pair, radiometry, close, found);
  };
  return beyond;
}

}  // namespace ridgeline::reconstruct
