// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/acquisition.h"

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

const CoreCandidate* candidate_of(const CoreCandidates& candidates, int right) {
  for (const CoreCandidate& c : candidates.list) {
    if (c.right == right) return &c;
  }
  return nullptr;
}

}  // namespace

Acquisition::Acquisition(const View& left,
                         const View& right,
                         const std::vector<CoreCandidates>& candidates,
                         const std::optional<ChoiceByAppearance>& by_appearance)
    : left_(left),
      right_(right),
      candidates_(candidates),
      by_appearance_(by_appearance),
      acquired_(candidates.size()),
      outcomes_(candidates.size()),
      takers_(right.segments.size()),
      wanters_(right.segments.size()) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    outcomes_[i] = candidates[i].reason;
    for (const CoreCandidate& c : candidates[i].list) {
      if (!c.may_begin) continue;
      wanters_[c.right].push_back(static_cast<int>(i));
      outcomes_[i] = ChioOutcome::kOutOfReach;
    }
  }
}

const CoreCandidate& Acquisition::counterpart(int left) const {
  return candidates_[left].list[acquired_[left]->candidate];
}

bool Acquisition::is_free(int left, const CoreCandidate& candidate) const {
  const std::vector<int>& takers = takers_[candidate.right];
  const Segment2& segment = left_.segments[left].line.segment;
  return std::all_of(takers.begin(), takers.end(), [&](int other) {
    const Segment2& taker = left_.segments[other].line.segment;
    const CoreCandidate* taken = candidate_of(candidates_[other], candidate.right);
    return taken ? may_share_counterpart({segment, candidate.overlap}, {taker, taken->overlap})
                 : are_fragments(segment, taker);
  });
}

bool Acquisition::has_rival(int left, const CoreCandidate& best, const Allowed& allowed) const {
  const Segment2& edge = right_.segments[best.right].line.segment;
  const auto& list = candidates_[left].list;
  return std::any_of(list.begin(), list.end(), [&](const CoreCandidate& c) {
    return c.may_begin && c.right != best.right && allowed(c) &&
           c.similarity > by_appearance_->max_similarity_ratio * best.similarity &&
           !are_fragments(edge, right_.segments[c.right].line.segment);
  });
}

bool Acquisition::is_wanted_more(int left, const CoreCandidate& best) const {
  const std::vector<int>& wanters = wanters_[best.right];
  return std::any_of(wanters.begin(), wanters.end(), [&](int other) {
    if (other == left || !is_open(other)) return false;
    const CoreCandidate* theirs = candidate_of(candidates_[other], best.right);
    return best.similarity < by_appearance_->max_similarity_ratio * theirs->similarity &&
           !may_share_counterpart({left_.segments[left].line.segment, best.overlap},
                                  {left_.segments[other].line.segment, theirs->overlap});
  });
}

std::optional<int> Acquisition::choose(int left, const Allowed& allowed) {
  const auto& list = candidates_[left].list;
  const auto best = std::find_if(list.begin(), list.end(),
                                 [&](const CoreCandidate& c) { return c.may_begin && allowed(c); });
  if (best == list.end()) {
    if (!list.empty() && list.front().may_begin) outcomes_[left] = ChioOutcome::kHeight;
    return std::nullopt;
  }
  if (by_appearance_ && best->similarity < by_appearance_->min_similarity) {
    outcomes_[left] = ChioOutcome::kLowScore;
    return std::nullopt;
  }
  if (!is_free(left, *best)) {
    outcomes_[left] = ChioOutcome::kLostToOther;
    return std::nullopt;
  }
  if (by_appearance_ && (has_rival(left, *best, allowed) || is_wanted_more(left, *best))) {
    outcomes_[left] = ChioOutcome::kAmbiguous;
    return std::nullopt;
  }
  return static_cast<int>(best - list.begin());
}

void Acquisition::acquire(int left, const Acquired& acquired) {
  acquired_[left] = acquired;
  outcomes_[left] = ChioOutcome::kMatched;
  takers_[counterpart(left).right].push_back(left);
}

}  // namespace ridgeline::reconstruct
