// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/depth_consensus.h"

#include "reconstruct/estimate/beyond/depth_consensus/depth_profiles.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <iterator>

namespace ridgeline::reconstruct {
namespace {

constexpr double kHorizontalSigma = 3.0;

std::vector<DepthProfile> hypotheses(const DepthQuestion& question, const DepthScorer& scorer) {
  std::vector<DepthProfile> all = straight_profiles(question, scorer);
  std::vector<DepthProfile> gables = gable_profiles(question, scorer);
  std::move(gables.begin(), gables.end(), std::back_inserter(all));
  if (auto row = row_profile(question, scorer)) all.push_back(std::move(*row));
  return all;
}

std::vector<DepthPart> parts_of(const DepthProfile& profile,
                                const DepthQuestion& question,
                                const DepthScorer& scorer) {
  std::vector<DepthPart> parts(profile.lines.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    DepthPart& part = parts[p];
    part.line = profile.lines[p];
    if (p > 0) part.from = profile.cuts[p - 1];
    if (p < profile.cuts.size()) part.to = profile.cuts[p];
    for (std::size_t i = 0; i < question.evidence.size(); ++i) {
      const DepthEvidence& e = question.evidence[i];
      const bool is_here = scorer.line_at(profile, e.parameter) == p ||
                           (part.from && scorer.is_at(*part.from, e)) ||
                           (part.to && scorer.is_at(*part.to, e));
      if (is_here && scorer.supports(e, profile.lines[p])) part.supports.push_back(i);
    }
    part.horizontal =
        slope(profile.lines[p].direction) <= kHorizontalSigma * question.building.sigma_slope;
  }
  return parts;
}

}  // namespace

std::optional<DepthConsensus> agree_on_depth(const DepthQuestion& question) {
  constexpr double kAnother_m = 1.0;
  const DepthScorer scorer(question);
  const std::vector<DepthProfile> all = hypotheses(question, scorer);
  if (all.empty()) return std::nullopt;
  const std::vector<double> scores =
      transformed(all, [&](const DepthProfile& profile) { return scorer.score(profile); });
  const auto at = std::max_element(scores.begin(), scores.end()) - scores.begin();
  const DepthProfile& best = all[static_cast<std::size_t>(at)];

  DepthConsensus consensus;
  consensus.parts = parts_of(best, question, scorer);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (scorer.apart_m(all[i], best) <= kAnother_m) continue;
    consensus.margin = std::min(consensus.margin, scores[static_cast<std::size_t>(at)] - scores[i]);
  }
  return consensus;
}

}  // namespace ridgeline::reconstruct
