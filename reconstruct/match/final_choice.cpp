// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/final_choice.h"

#include <algorithm>
#include <map>

namespace ridgeline::reconstruct {
namespace {

/// A candidate by left segment and rank.
struct Choice {
  int left;
  int candidate;
};

std::vector<Choice> by_probability(const Supports& supports) {
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    for (std::size_t c = 0; c < supports[i].size(); ++c) {
      choices.push_back({static_cast<int>(i), static_cast<int>(c)});
    }
  }
  std::stable_sort(choices.begin(), choices.end(), [&](const Choice& a, const Choice& b) {
    return supports[a.left][a.candidate].probability > supports[b.left][b.candidate].probability;
  });
  return choices;
}

/// Why a left segment whose best candidate is below min_probability has no mate.
MatchOutcome reason(const std::vector<Support>& supports) {
  std::vector<double> p;
  p.reserve(supports.size());
  for (const Support& s : supports) p.push_back(s.probability);
  const auto best = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  const Support& winner = supports[best];
  std::nth_element(p.begin(), p.begin() + (p.size() > 1 ? 1 : 0), p.end(), std::greater<>());
  const double second = p.size() > 1 ? p[1] : 0.0;
  if (second > 0.5 * winner.probability && winner.probability > 0.2)
    return MatchOutcome::kAmbiguous;
  return winner.n_pairs == 0 ? MatchOutcome::kNoPair : MatchOutcome::kLowScore;
}

}  // namespace

const char* name(MatchOutcome outcome) {
  switch (outcome) {
    case MatchOutcome::kMatched:
      return "matched";
    case MatchOutcome::kNoCandidate:
      return "no_candidate";
    case MatchOutcome::kLowScore:
      return "low_score";
    case MatchOutcome::kAmbiguous:
      return "ambiguous";
    case MatchOutcome::kNoPair:
      return "no_pair";
    case MatchOutcome::kLostVote:
      return "lost_vote";
  }
  return "";
}

MatchResult final_choice(const MatchView& left,
                         const std::vector<std::vector<Candidate>>& candidates,
                         const Supports& supports,
                         const MatchOptions& options) {
  MatchResult result;
  result.outcomes.resize(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    result.outcomes[i] = candidates[i].empty() ? MatchOutcome::kNoCandidate : reason(supports[i]);
  }
  std::map<int, std::vector<Choice>> takers;  // by right segment
  for (const Choice& choice : by_probability(supports)) {
    const Support& support = supports[choice.left][choice.candidate];
    MatchOutcome& outcome = result.outcomes[choice.left];
    if (support.probability < options.min_probability) break;
    if (outcome == MatchOutcome::kMatched) continue;
    const Candidate& candidate = candidates[choice.left][choice.candidate];
    std::vector<Choice>& others = takers[candidate.right];
    const bool free = std::all_of(others.begin(), others.end(), [&](const Choice& other) {
      return may_share_mate(left.segments[choice.left].line.segment, candidate.overlap,
                            left.segments[other.left].line.segment,
                            candidates[other.left][other.candidate].overlap);
    });
    outcome = free ? MatchOutcome::kMatched : MatchOutcome::kLostVote;
    if (!free) continue;
    others.push_back(choice);
    result.matches.push_back({{choice.left, candidate.right}, support.probability, support.votes});
  }
  std::sort(result.matches.begin(), result.matches.end(),
            [](const ScoredMatch& a, const ScoredMatch& b) { return a.match.left < b.match.left; });
  return result;
}

}  // namespace ridgeline::reconstruct
