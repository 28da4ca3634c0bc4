// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/match_pairwise.h"

#include "reconstruct/match/close_lines.h"
#include "reconstruct/match/final_choice.h"
#include "reconstruct/match/hidden_strips.h"
#include "reconstruct/match/matched_radiometry.h"
#include "reconstruct/match/similarity_voting.h"

#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

std::vector<PairMatch> all_pair_matches(const PairScene& scene, std::span<const BasePair> pairs) {
  std::vector<std::vector<PairMatch>> found(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(),
                    [&](std::size_t p) { found[p] = pair_matches(scene, pairs[p]); });
  std::vector<PairMatch> all;
  for (const std::vector<PairMatch>& matches : found) {
    all.insert(all.end(), matches.begin(), matches.end());
  }
  return all;
}

}  // namespace

MatchResult match_pairwise(const MatchView& left,
                           const MatchView& right,
                           const std::array<double, 2>& height_range_in_local_m,
                           const MatchOptions& options) {
  validate(options);
  check_images(left, right);
  const StereoSearch search(left.image_from_local, right.image_from_local, height_range_in_local_m);
  Radiometry radiometry = relative_radiometry(left.segments, right.segments);
  if (options.matched_radiometry) {
    radiometry = matched_radiometry(left, right, search, radiometry, options);
  }
  std::vector<std::vector<Candidate>> candidates =
      match_candidates(left, right, search, radiometry, options);
  const std::array<CloseLines, 2> close{close_lines(ideal_segments(left)),
                                        close_lines(ideal_segments(right))};
  if (options.close_lines) keep_order_of_close_lines(left, search, close, candidates);
  if (options.hidden_walls) {
    compare_across_hidden_strips({&left, &right}, search, radiometry, close, candidates);
  }
  const LocalTransfer transfer =
      local_transfer(search, {0.5 * left.image.cols, 0.5 * left.image.rows});
  const std::vector<BasePair> pairs = base_pairs(ideal_segments(left), options);
  const PairScene scene{left,
                        right,
                        search,
                        {ImageSampler(left.image), ImageSampler(right.image), radiometry},
                        candidates,
                        options,
                        relief_spread(transfer)};
  const std::vector<PairMatch> pair_matches = all_pair_matches(scene, pairs);
  const Supports supports = similarity_votes(left, right, candidates, pair_matches, transfer);
  return final_choice(left, right, candidates, supports, pairs, options);
}

}  // namespace ridgeline::reconstruct
