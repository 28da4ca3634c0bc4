// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/match/chio_wang2000/core.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/scene/scene.h"

#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// How a left segment got its counterpart.
struct Acquired {
  int candidate = 0;  ///< index of the initial link in the list of the left segment
  int process = 0;    ///< 1 to 4
  /// The matched left segment whose height constrained the line; -1 in the first process.
  int neighbour = -1;
  double height_m = 0.0;  ///< height of the neighbour
  double limit_m = 0.0;   ///< largest difference from the height of the neighbour
  bool relaxed = false;   ///< whether limit_m is the relaxed limit
};

/// The left segments and what they have acquired so far.
class Acquisition {
 public:
  using Allowed = std::function<bool(const CoreCandidate&)>;

  Acquisition(const View& left,
              const View& right,
              const std::vector<CoreCandidates>& candidates,
              const std::optional<ChoiceByAppearance>& by_appearance);

  /// Whether a left segment has a counterpart among its candidates.
  [[nodiscard]] bool is_matched(int left) const { return acquired_[left].has_value(); }
  [[nodiscard]] bool is_open(int left) const { return outcomes_[left] != ChioOutcome::kMatched; }
  /// The candidate that a matched segment took.
  [[nodiscard]] const CoreCandidate& counterpart(int left) const;
  [[nodiscard]] const std::vector<std::optional<Acquired>>& acquired() const { return acquired_; }
  [[nodiscard]] const std::vector<ChioOutcome>& outcomes() const { return outcomes_; }

  /// Index of the candidate that Core chooses for an unmatched segment: the most preferred one of
  /// those that are allowed and may begin. If there is none, or if another left edge has taken it,
  /// the result is empty and the outcome gives the reason. If the appearance decides, the result is
  /// also empty if the similarity of the candidate is
  ///   - below min_similarity,
  ///   - not clearly above that of another candidate, which exceeds max_similarity_ratio times it,
  ///     or
  ///   - below max_similarity_ratio times the similarity between the candidate and another
  ///     unmatched left segment.
  std::optional<int> choose(int left, const Allowed& allowed);
  void acquire(int left, const Acquired& acquired);

 private:
  [[nodiscard]] bool is_free(int left, const CoreCandidate& candidate) const;
  [[nodiscard]] bool has_rival(int left, const CoreCandidate& best, const Allowed& allowed) const;
  [[nodiscard]] bool is_wanted_more(int left, const CoreCandidate& best) const;

  const View& left_;
  const View& right_;
  const std::vector<CoreCandidates>& candidates_;
  const std::optional<ChoiceByAppearance>& by_appearance_;
  std::vector<std::optional<Acquired>> acquired_;
  std::vector<ChioOutcome> outcomes_;
  std::vector<std::vector<int>> takers_;  ///< by right segment: the left segments matched with it
  /// By right segment: the left segments whose initial link it may be.
  std::vector<std::vector<int>> wanters_;
};

}  // namespace ridgeline::reconstruct
