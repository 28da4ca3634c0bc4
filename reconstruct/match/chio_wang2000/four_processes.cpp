// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/four_processes.h"

#include "reconstruct/match/chio_wang2000/neighbourhood.h"
#include "reconstruct/match/chio_wang2000/structures.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace ridgeline::reconstruct {
namespace {

/// Largest distance of a junction from its counterpart's epipolar line; ours, because the paper
/// gives none.
constexpr double kMaxJunctionEpipolar_px = 2.0;

enum class HeightLimit : std::uint8_t { kClose, kRelaxed };

/// A right junction that may show the junction of a left structure.
struct SharedJunction {
  int structure = 0;  ///< index of the right structure
  /// Members of the left structure with a counterpart in the right one, strongest first.
  std::vector<int> members;
  double strength = 0.0;
};

class Iteration {
 public:
  Iteration(const SearchedPair& pair,
            const std::vector<CoreCandidates>& candidates,
            const ChioOptions& options,
            const ChioExtensions& beyond)
      : left_segments_(ideal_segments(pair.left)),
        search_(pair.search),
        candidates_(candidates),
        options_(options),
        by_appearance_(beyond.by_appearance),
        heights_(left_segments_, beyond.noise),
        structures_(linear_structures(left_segments_)),
        right_structures_(linear_structures(ideal_segments(pair.right))),
        right_of_segment_(structures_of_segments(right_structures_, pair.right.segments.size())),
        acquisition_(pair.left, pair.right, candidates, by_appearance_) {}

  ProcessedSegments run() {
    for (const Structure& structure : structures_) first_and_second(structure);
    third_and_fourth();
    return {acquisition_.acquired(), acquisition_.outcomes()};
  }

 private:
  void third_and_fourth() {
    const Neighbourhood adjacent = adjacent_segments(left_segments_, structures_);
    const Neighbourhood near = segments_in_range(left_segments_, candidates_, options_.range_m);
    for (const HeightLimit limit : {HeightLimit::kClose, HeightLimit::kRelaxed}) {
      int n_found = 1;
      while (n_found > 0) {
        n_found = until_nothing_changes(3, adjacent, limit);
        n_found += until_nothing_changes(4, near, limit);
      }
    }
  }

  [[nodiscard]] double limit_m(HeightLimit limit) const {
    return limit == HeightLimit::kClose ? options_.height_difference_m : kRelaxedHeightDifference_m;
  }

  /// Tries to match a segment under the height constraint of one neighbour. If a right structure is
  /// given, the counterpart must be a member of it.
  bool acquire_beside(int process,
                      int left,
                      const Neighbour& neighbour,
                      HeightLimit limit,
                      const Structure* right_structure) {
    const CoreCandidate& counterpart = acquisition_.counterpart(neighbour.left);
    const auto choice = acquisition_.choose(left, [&](const CoreCandidate& c) {
      return (!right_structure || has_member(*right_structure, c.right)) &&
             heights_.agree(left, c, neighbour, counterpart, limit_m(limit));
    });
    if (!choice) return false;
    acquisition_.acquire(
        left, {*choice, process, neighbour.left, heights_.height_of(neighbour, counterpart),
               limit_m(limit), limit == HeightLimit::kRelaxed});
    return true;
  }

  static bool has_member(const Structure& structure, int segment) {
    return std::binary_search(structure.members.begin(), structure.members.end(), segment);
  }

  /// How strongly a member supports a corresponding junction.
  [[nodiscard]] double strength(const CoreCandidate& candidate) const {
    return by_appearance_ ? candidate.similarity : candidate.chain.n_reliable;
  }

  /// The best candidate of a left segment among the members of a right structure. For a matched
  /// segment, only its counterpart is considered. Null if there is none.
  [[nodiscard]] const CoreCandidate* best_in(int left, const Structure& right) const {
    if (acquisition_.is_matched(left)) {
      const CoreCandidate& counterpart = acquisition_.counterpart(left);
      return has_member(right, counterpart.right) ? &counterpart : nullptr;
    }
    for (const CoreCandidate& c : candidates_[left].list) {
      if (c.may_begin && has_member(right, c.right)) return &c;
    }
    return nullptr;
  }

  [[nodiscard]] SharedJunction shared_junction(const Structure& structure, int right) const {
    SharedJunction found{right, {}, 0.0};
    std::map<int, double> by_member;
    std::vector<int> used;
    for (const int member : structure.members) {
      const CoreCandidate* best = best_in(member, right_structures_[right]);
      if (!best || std::find(used.begin(), used.end(), best->right) != used.end()) continue;
      used.push_back(best->right);
      found.members.push_back(member);
      by_member[member] = strength(*best);
      found.strength += strength(*best);
    }
    std::ranges::stable_sort(found.members, std::greater{}, [&](int m) { return by_member[m]; });
    return found;
  }

  /// The right junctions on the epipolar line of a left junction that have counterparts of at least
  /// two members of its structure, best first.
  [[nodiscard]] std::vector<SharedJunction> shared_junctions(const Structure& structure) const {
    std::set<int> right;
    for (const int member : structure.members) {
      for (const CoreCandidate& c : candidates_[member].list) {
        right.insert(right_of_segment_[c.right].begin(), right_of_segment_[c.right].end());
      }
    }
    std::vector<SharedJunction> found;
    for (const int r : right) {
      if (epipolar_distance_px(search_.right_from_left.fundamental(), structure.junction_px,
                               right_structures_[r].junction_px) > kMaxJunctionEpipolar_px) {
        continue;
      }
      found.push_back(shared_junction(structure, r));
    }
    std::erase_if(found, [](const SharedJunction& c) { return c.members.size() < 2; });
    std::ranges::stable_sort(found, std::greater{}, [](const SharedJunction& c) {
      return std::pair(c.members.size(), c.strength);
    });
    return found;
  }

  [[nodiscard]] bool is_ambiguous(const std::vector<SharedJunction>& found) const {
    return by_appearance_ && found.size() > 1 &&
           found[1].members.size() == found[0].members.size() &&
           found[1].strength > by_appearance_->max_similarity_ratio * found[0].strength;
  }

  void first_and_second(const Structure& structure) {
    const std::vector<SharedJunction> found = shared_junctions(structure);
    if (found.empty() || is_ambiguous(found)) return;
    const Structure& right = right_structures_[found.front().structure];
    const std::vector<int>& members = found.front().members;
    auto first = std::ranges::find_if(members, [&](int m) { return acquisition_.is_matched(m); });
    for (auto m = members.begin(); first == members.end() && m != members.end(); ++m) {
      const auto choice = acquisition_.choose(
          *m, [&](const CoreCandidate& c) { return has_member(right, c.right); });
      if (!choice) continue;
      acquisition_.acquire(*m, {*choice, 1});
      first = m;
    }
    if (first == members.end()) return;
    for (const int m : structure.members) {
      if (acquisition_.is_matched(m)) continue;
      acquire_beside(2, m, {*first, structure.junction_px, 0.0}, HeightLimit::kClose, &right);
    }
  }

  /// Passes over all unmatched segments until a pass finds nothing. Returns how many segments were
  /// matched.
  int until_nothing_changes(int process, const Neighbourhood& neighbourhood, HeightLimit limit) {
    int n_found = 0;
    for (int n_before = -1; n_before != n_found;) {
      n_before = n_found;
      for (std::size_t i = 0; i < neighbourhood.size(); ++i) {
        const int left = static_cast<int>(i);
        if (!acquisition_.is_open(left)) continue;
        for (const Neighbour& neighbour : neighbourhood[i]) {
          if (!acquisition_.is_matched(neighbour.left)) continue;
          if (acquire_beside(process, left, neighbour, limit, nullptr)) {
            ++n_found;
            break;
          }
        }
      }
    }
    return n_found;
  }

  std::vector<Segment2> left_segments_;
  const StereoSearch& search_;
  const std::vector<CoreCandidates>& candidates_;
  const ChioOptions& options_;
  const std::optional<ChoiceByAppearance>& by_appearance_;
  NeighbourHeights heights_;
  std::vector<Structure> structures_, right_structures_;
  std::vector<std::vector<int>> right_of_segment_;
  Acquisition acquisition_;
};

}  // namespace

ProcessedSegments four_processes(const SearchedPair& pair,
                                 const std::vector<CoreCandidates>& candidates,
                                 const ChioOptions& options,
                                 const ChioExtensions& beyond) {
  return Iteration(pair, candidates, options, beyond).run();
}

}  // namespace ridgeline::reconstruct
