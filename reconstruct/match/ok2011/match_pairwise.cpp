// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/match_pairwise.h"

#include "reconstruct/geometry/interruption.h"
#include "reconstruct/match/ok2011/final_choice.h"
#include "reconstruct/match/ok2011/similarity_voting.h"

#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

std::vector<PairMatch> all_pair_matches(const PairScene& scene, std::span<const BasePair> pairs) {
  std::vector<std::vector<PairMatch>> found(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t p) {
    Interruption::check();
    found[p] = pair_matches(scene, pairs[p]);
  });
  std::vector<PairMatch> all;
  for (const std::vector<PairMatch>& matches : found) {
    all.insert(all.end(), matches.begin(), matches.end());
  }
  return all;
}

}  // namespace

MatchResult match_pairwise(const StereoPair& pair,
                           const MatchOptions& options,
                           const CandidateOptions& candidate_options,
                           const MatchExtensions& beyond) {
  validate(options);
  const SearchedPair views = searched(pair);
  const auto& [left, right, search] = views;
  Radiometry radiometry = relative_radiometry(left.segments, right.segments);
  if (beyond.radiometry) radiometry = beyond.radiometry(views, radiometry);
  Candidates candidates = match_candidates(views, radiometry, candidate_options, beyond.appearance);
  if (beyond.candidates) beyond.candidates(views, radiometry, candidates);
  const LocalTransfer transfer =
      local_transfer(search, {0.5 * left.image.cols, 0.5 * left.image.rows});
  const std::vector<BasePair> pairs = base_pairs(ideal_segments(left));
  const PairScene scene{views,
                        {ImageSampler(left.image), ImageSampler(right.image), radiometry},
                        candidates,
                        relief_spread(transfer)};
  const std::vector<PairMatch> pair_matches = all_pair_matches(scene, pairs);
  const MatchChoices choices{left, right, candidates};
  const Supports supports = similarity_votes(choices, pair_matches, transfer);
  return final_choice(choices, supports, pairs, options);
}

}  // namespace ridgeline::reconstruct
