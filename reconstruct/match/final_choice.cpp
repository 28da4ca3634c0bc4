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

std::size_t best_of(const std::vector<Support>& supports) {
  const auto best = std::max_element(
      supports.begin(), supports.end(),
      [](const Support& a, const Support& b) { return a.probability < b.probability; });
  return static_cast<std::size_t>(best - supports.begin());
}

/// Probability of the next mate over that of the best, fragments of the best one's edge left out.
double distance_ratio(const MatchView& right,
                      const std::vector<Candidate>& candidates,
                      const std::vector<Support>& supports) {
  const std::size_t best = best_of(supports);
  const Segment2& mate = right.segments[candidates[best].right].line.segment;
  double next = 0.0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (c == best || are_fragments(mate, right.segments[candidates[c].right].line.segment))
      continue;
    next = std::max(next, supports[c].probability);
  }
  return next / std::max(supports[best].probability, 1e-12);
}

/// By left segment: how many of its partners have a mate that can be trusted, and could vote.
std::vector<int> voters(std::span<const BasePair> pairs,
                        const Supports& supports,
                        const MatchOptions& options) {
  const auto trusted = [&](int i) {
    return !supports[i].empty() &&
           supports[i][best_of(supports[i])].probability >= options.min_probability;
  };
  std::vector<int> count(supports.size(), 0);
  for (const BasePair& pair : pairs) {
    if (trusted(pair.second)) ++count[pair.first];
    if (trusted(pair.first)) ++count[pair.second];
  }
  return count;
}

/// Whether too few of a line's pairs speak for its candidate; an isolated line is taken by its look,
/// if that leaves no doubt.
bool lacks_votes(const Support& support, int n_voters, const MatchOptions& options) {
  constexpr int kIsolated = 1;
  if (support.votes >= options.min_votes) return false;
  return n_voters > kIsolated || support.probability < options.min_isolated_probability;
}

/// What becomes of a left segment before the others are asked.
MatchOutcome prospect(const MatchView& right,
                      const std::vector<Candidate>& candidates,
                      const std::vector<Support>& supports,
                      int n_voters,
                      const MatchOptions& options) {
  constexpr double kWeak = 0.2;  // of two equally weak candidates neither is right
  if (candidates.empty()) return MatchOutcome::kNoCandidate;
  const Support& best = supports[best_of(supports)];
  if (best.probability > kWeak &&
      distance_ratio(right, candidates, supports) > options.max_distance_ratio) {
    return MatchOutcome::kAmbiguous;
  }
  if (lacks_votes(best, n_voters, options)) return MatchOutcome::kNoPair;
  if (best.probability >= options.min_probability) return MatchOutcome::kLostVote;
  return best.n_pairs == 0 ? MatchOutcome::kNoPair : MatchOutcome::kLowScore;
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
                         const MatchView& right,
                         const std::vector<std::vector<Candidate>>& candidates,
                         const Supports& supports,
                         std::span<const BasePair> pairs,
                         const MatchOptions& options) {
  const std::vector<int> n_voters = voters(pairs, supports, options);
  MatchResult result;
  result.outcomes.resize(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    result.outcomes[i] = prospect(right, candidates[i], supports[i], n_voters[i], options);
  }
  std::map<int, std::vector<Choice>> takers;  // by right segment
  for (const Choice& choice : by_probability(supports)) {
    const Support& support = supports[choice.left][choice.candidate];
    MatchOutcome& outcome = result.outcomes[choice.left];
    if (support.probability < options.min_probability) break;
    if (outcome != MatchOutcome::kLostVote) continue;  // matched, ambiguous or without pairs
    if (lacks_votes(support, n_voters[choice.left], options)) continue;
    const Candidate& candidate = candidates[choice.left][choice.candidate];
    std::vector<Choice>& others = takers[candidate.right];
    const bool free = std::all_of(others.begin(), others.end(), [&](const Choice& other) {
      return may_share_mate(left.segments[choice.left].line.segment, candidate.overlap,
                            left.segments[other.left].line.segment,
                            candidates[other.left][other.candidate].overlap);
    });
    if (!free) continue;
    outcome = MatchOutcome::kMatched;
    others.push_back(choice);
    result.matches.push_back({{choice.left, candidate.right}, support.probability, support.votes});
  }
  std::sort(result.matches.begin(), result.matches.end(),
            [](const ScoredMatch& a, const ScoredMatch& b) { return a.match.left < b.match.left; });
  return result;
}

}  // namespace ridgeline::reconstruct
