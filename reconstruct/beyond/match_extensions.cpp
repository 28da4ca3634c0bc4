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
    beyond.radiometry = [candidates, look = beyond.look](
                            const MatchView& left, const MatchView& right,
                            const StereoSearch& search, const Radiometry& first) {
      return matched_radiometry(left, right, search, first, candidates, look);
    };
  }
  if (!options.close_lines && !options.hidden_walls) return beyond;
  beyond.candidates = [options](const MatchView& left, const MatchView& right,
                                const StereoSearch& search, const Radiometry& radiometry,
                                std::vector<std::vector<Candidate>>& found) {
    const std::array<CloseLines, 2> close{close_lines(ideal_segments(left)),
                                          close_lines(ideal_segments(right))};
    if (options.close_lines) keep_order_of_close_lines(left, search, close, found);
    if (options.hidden_walls) {
      compare_across_hidden_strips({&left, &right}, search, radiometry, close, found);
    }
  };
  return beyond;
}

}  // namespace ridgeline::reconstruct
