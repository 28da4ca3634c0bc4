// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/core.h"
#include "reconstruct/chio_wang2000/extensions.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/views/scene.h"

#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// How a left segment got its mate.
struct Acquired {
  int candidate = 0;  ///< the initial link, in the list of the left segment
  int process = 0;    ///< 1 to 4; 0: taken over from another matcher
  /// The matched left segment whose height the line had to have, that height and the largest
  /// difference. No neighbour, -1, in the first process.
  int neighbour = -1;
  double height_m = 0.0;
  double limit_m = 0.0;
  bool relaxed = false;  ///< by the relaxed limit
};

/// The left segments and what they have acquired so far.
class Acquisition {
 public:
  using Allowed = std::function<bool(const CoreCandidate&)>;

  Acquisition(const View& left,
              const View& right,
              const std::vector<CoreCandidates>& candidates,
              const std::optional<ChoiceByLook>& by_look);

  /// With a mate that Core knows.
  [[nodiscard]] bool is_matched(int left) const { return acquired_[left].has_value(); }
  [[nodiscard]] bool is_open(int left) const { return outcomes_[left] != ChioOutcome::kMatched; }
  /// The candidate that a matched segment took.
  [[nodiscard]] const CoreCandidate& mate(int left) const;
  [[nodiscard]] const std::vector<std::optional<Acquired>>& acquired() const { return acquired_; }
  [[nodiscard]] const std::vector<ChioOutcome>& outcomes() const { return outcomes_; }

  /// Index of the candidate that Core chooses for an unmatched segment among those allowed: the most
  /// preferred one that may begin. Nothing, and the outcome says why, if there is none or if another
  /// left edge has taken it. If the look decides, also nothing if the candidate looks less than
  /// min_similarity alike or a rival comes closer than max_similarity_ratio: another candidate, or
  /// another unmatched left segment that looks more like this one.
  std::optional<int> choose(int left, const Allowed& allowed);
  void acquire(int left, const Acquired& acquired);
  /// Takes a match of another matcher over, with process 0. It can give its height to others if it is
  /// among the candidates; else it only keeps its two segments from others.
  void accept(const LineMatch& match);

 private:
  [[nodiscard]] bool is_free(int left, const CoreCandidate& candidate) const;
  [[nodiscard]] bool has_rival(int left, const CoreCandidate& best, const Allowed& allowed) const;
  [[nodiscard]] bool is_wanted_more(int left, const CoreCandidate& best) const;

  const View& left_;
  const View& right_;
  const std::vector<CoreCandidates>& candidates_;
  const std::optional<ChoiceByLook>& by_look_;
  std::vector<std::optional<Acquired>> acquired_;
  std::vector<ChioOutcome> outcomes_;
  std::vector<std::vector<int>> takers_;   ///< by right segment: the left ones matched with it
  std::vector<std::vector<int>> wanters_;  ///< by right segment: the left ones it may begin
};

}  // namespace ridgeline::reconstruct
