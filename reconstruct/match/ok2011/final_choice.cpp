// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/final_choice.h"

#include <algorithm>
#include <map>

namespace ridgeline::reconstruct {
namespace {

/// Largest ratio of the probability of the second best counterpart to that of the best one; ours.
constexpr double kMaxDistanceRatio = 0.8;
/// Minimum probability of a match without matched partners, which is judged by its appearance only;
/// ours.
constexpr double kMinIsolatedProbability = 0.98;

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
  std::ranges::stable_sort(choices, std::greater{}, [&](const Choice& c) {
    return supports[c.left][c.candidate].probability;
  });
  return choices;
}

std::size_t best_of(const std::vector<Support>& supports) {
  const auto best = std::ranges::max_element(supports, {}, &Support::probability);
  return static_cast<std::size_t>(best - supports.begin());
}

/// Ratio of the probability of the second best counterpart to that of the best one. Fragments of
/// the best counterpart's edge do not count as second best.
double distance_ratio(const MatchChoices& choices, std::size_t i, const Supports& of_all) {
  const std::vector<Candidate>& candidates = choices.candidates[i];
  const std::vector<Support>& supports = of_all[i];
  const std::size_t best = best_of(supports);
  const Segment2& counterpart = choices.counterpart(candidates[best]);
  double next = 0.0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (c == best || are_fragments(counterpart, choices.counterpart(candidates[c]))) continue;
    next = std::max(next, supports[c].probability);
  }
  return next / std::max(supports[best].probability, 1e-12);
}

/// The smallest probability at which a candidate is taken. The shortest segments find something
/// similar by chance, above all in textures. If one segment is much shorter than the other, their
/// ends are no evidence that both show the same edge.
double least_probability(const Segment2& left, const Segment2& right, const MatchOptions& options) {
  constexpr double kShort_px = 12.0;
  constexpr double kOfShort = 0.9;
  constexpr double kUnlike = 0.75;  // share of the longer one
  constexpr double kOfUnlike = 0.6;
  const auto [shorter_px, longer_px] = std::minmax({length(left), length(right)});
  double least = options.min_probability;
  if (shorter_px < kShort_px) least = std::max(least, kOfShort);
  if (shorter_px < kUnlike * longer_px) least = std::max(least, kOfUnlike);
  return least;
}

/// For each left segment, how many of its partners have a trustworthy counterpart and could
/// therefore vote.
std::vector<int> voters(const MatchChoices& choices,
                        std::span<const BasePair> pairs,
                        const Supports& supports,
                        const MatchOptions& options) {
  const auto trusted = [&](int i) {
    if (supports[i].empty()) return false;
    const std::size_t best = best_of(supports[i]);
    return supports[i][best].probability >=
           least_probability(choices.left_line(i), choices.counterpart(choices.candidates[i][best]),
                             options);
  };
  std::vector<int> count(supports.size(), 0);
  for (const BasePair& pair : pairs) {
    if (trusted(pair.second)) ++count[pair.first];
    if (trusted(pair.first)) ++count[pair.second];
  }
  return count;
}

/// Whether a line's pairs give its candidate too few votes. An isolated line is accepted by its
/// appearance if that leaves no doubt.
bool lacks_votes(const Support& support, int n_voters, const MatchOptions& options) {
  constexpr int kIsolated = 1;
  if (support.votes >= options.min_votes) return false;
  return n_voters > kIsolated || support.probability < kMinIsolatedProbability;
}

/// The outcome of a left segment before the other left segments are considered.
MatchOutcome prospect(const MatchChoices& choices,
                      std::size_t i,
                      const Supports& of_all,
                      int n_voters,
                      const MatchOptions& options) {
  constexpr double kWeak = 0.2;  // if two candidates are equally weak, neither is correct
  const std::vector<Candidate>& candidates = choices.candidates[i];
  const std::vector<Support>& supports = of_all[i];
  if (candidates.empty()) return MatchOutcome::kNoCandidate;
  const std::size_t first = best_of(supports);
  const Support& best = supports[first];
  const Segment2& counterpart = choices.counterpart(candidates[first]);
  if (best.probability > kWeak && distance_ratio(choices, i, of_all) > kMaxDistanceRatio) {
    return MatchOutcome::kAmbiguous;
  }
  if (lacks_votes(best, n_voters, options)) return MatchOutcome::kNoPair;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const Segment2& fragment = choices.counterpart(candidates[c]);
    if ((c == first || are_fragments(counterpart, fragment)) &&
        supports[c].probability >= least_probability(choices.left_line(i), fragment, options)) {
      return MatchOutcome::kLostVote;
    }
  }
  return best.n_pairs == 0 ? MatchOutcome::kNoPair : MatchOutcome::kLowScore;
}

/// The choices made so far, by the segments of both images.
class Taken {
 public:
  explicit Taken(const MatchChoices& choices) : choices_(choices) {}

  void add(const Choice& choice) {
    of_left_[choice.left].push_back(choice);
    of_right_[candidate(choice).right].push_back(choice);
  }

  /// Whether neither segment already has a counterpart for the same part of it or one on another
  /// edge.
  [[nodiscard]] bool allow(const Choice& choice) const {
    const Candidate& own = candidate(choice);
    const auto shares = [&](const Choice& other) {
      return may_share_counterpart(choices_.on_left(choice.left, own),
                                   choices_.on_left(other.left, candidate(other)));
    };
    const auto adds = [&](const Choice& other) {
      return may_be_counterparts_of_one(choices_.on_right(own),
                                        choices_.on_right(candidate(other)));
    };
    const auto takers = of_right_.find(own.right);
    const auto counterparts = of_left_.find(choice.left);
    return (takers == of_right_.end() || std::ranges::all_of(takers->second, shares)) &&
           (counterparts == of_left_.end() || std::ranges::all_of(counterparts->second, adds));
  }

 private:
  [[nodiscard]] const Candidate& candidate(const Choice& choice) const {
    return choices_.candidates[choice.left][choice.candidate];
  }

  const MatchChoices& choices_;
  std::map<int, std::vector<Choice>> of_left_, of_right_;
};

}  // namespace

const char* name(MatchOutcome outcome) {
  constexpr std::array kNames{"matched",   "no_candidate", "low_score",
                              "ambiguous", "no_pair",      "lost_vote"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

MatchResult final_choice(const MatchChoices& choices,
                         const Supports& supports,
                         std::span<const BasePair> pairs,
                         const MatchOptions& options) {
  // A fragment has no rivals among the other fragments, so it appears more certain than it is.
  constexpr double kFurtherCounterpart = 0.7;
  const std::vector<int> n_voters = voters(choices, pairs, supports, options);
  MatchResult result;
  result.outcomes.resize(choices.candidates.size());
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    result.outcomes[i] = prospect(choices, i, supports, n_voters[i], options);
  }
  Taken taken(choices);
  for (const Choice& choice : by_probability(supports)) {
    const Support& support = supports[choice.left][choice.candidate];
    MatchOutcome& outcome = result.outcomes[choice.left];
    if (support.probability < options.min_probability) break;
    if (outcome != MatchOutcome::kLostVote && outcome != MatchOutcome::kMatched) continue;
    if (lacks_votes(support, n_voters[choice.left], options)) continue;
    const Candidate& counterpart = choices.candidates[choice.left][choice.candidate];
    if (support.probability < least_probability(choices.left_line(choice.left),
                                                choices.counterpart(counterpart), options)) {
      continue;
    }
    const bool is_further = outcome == MatchOutcome::kMatched;
    if (is_further && support.probability < kFurtherCounterpart) continue;
    if (!taken.allow(choice)) continue;
    outcome = MatchOutcome::kMatched;
    taken.add(choice);
    result.matches.push_back({choice.left, counterpart.right, support.probability, support.votes});
  }
  std::ranges::sort(result.matches, {}, &Correspondence::segments);
  return result;
}

}  // namespace ridgeline::reconstruct
