// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_ids.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace ridgeline::evaluate {
namespace {

/// Labels of points by their keys, in a table with open addressing: a cloud has millions of points,
/// and their keys are already hashes.
class PointLabels {
 public:
  PointLabels() : keys_(kFirstSlots, 0), labels_(kFirstSlots, 0) {}

  /// 0 for a point without a label.
  [[nodiscard]] std::uint32_t of(std::uint64_t key) const { return labels_[slot_of(key)]; }

  /// A point keeps its first label.
  void add(std::uint64_t key, std::uint32_t label) {
    const std::size_t slot = slot_of(key);
    if (labels_[slot] != 0) return;
    keys_[slot] = key;
    labels_[slot] = label;
    if (4 * ++n_used_ > 3 * labels_.size()) grow();
  }

 private:
  static constexpr std::size_t kFirstSlots = 1U << 10U;

  /// The slot that holds the key, or where it would be inserted.
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    const std::size_t mask = labels_.size() - 1;
    std::size_t slot = key & mask;
    while (labels_[slot] != 0 && keys_[slot] != key) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    const auto keys = std::exchange(keys_, std::vector<std::uint64_t>(2 * keys_.size(), 0));
    const auto labels = std::exchange(labels_, std::vector<std::uint32_t>(2 * labels_.size(), 0));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] == 0) continue;
      const std::size_t slot = slot_of(keys[i]);
      keys_[slot] = keys[i];
      labels_[slot] = labels[i];
    }
  }

  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> labels_;
  std::size_t n_used_ = 0;
};

std::array<double, 3> key_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

/// The numbers of the lines that have planes, sorted by position.
std::vector<std::size_t> judged_by_place(std::span<LineEvaluation* const> lines) {
  const auto place = [&](std::size_t i) {
    const auto& [start, end] = *lines[i]->segment;
    const auto [first, last] = std::minmax({key_of(start), key_of(end)});
    return std::pair(first, last);
  };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != nullptr && !lines[i]->planes.empty() && lines[i]->segment) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, place);
  return order;
}

/// The id of the plane with which a plane shares most of its points; 0 if there is none.
std::uint64_t common_id(const PlanePoints& points, std::span<LineEvaluation* const> lines) {
  constexpr double kShared = 0.3;  // neighbouring facets share only the points at their common edge
  std::map<std::uint64_t, std::size_t> votes;
  for (const SharedPoints& shared : points.shared) {
    check(shared.line < lines.size(), "a plane shares points with line ", shared.line, " of ",
          lines.size());
    const LineEvaluation* const line = lines[shared.line];
    if (line == nullptr) continue;
    check(shared.plane < line->planes.size() && line->planes[shared.plane].id != 0,
          "a plane shares points with plane ", shared.plane, " of line ", shared.line,
          ", which is not an earlier one");
    votes[line->planes[shared.plane].id] += shared.n;
  }
  const auto most =
      std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
  if (most == votes.end()) return 0;
  const bool is_enough =
      static_cast<double>(most->second) >= kShared * static_cast<double>(points.n);
  return is_enough ? most->first : 0;
}

}  // namespace

void find_shared_points(std::span<JudgedResult> results) {
  std::vector<LineEvaluation*> lines;
  for (JudgedResult& result : results) lines.push_back(&result.evaluation);
  PointLabels first;  // the number, from 1, of the plane that has a point
  std::vector<std::pair<std::size_t, std::size_t>> planes;
  for (const std::size_t i : judged_by_place(lines)) {
    for (std::size_t p = 0; p < results[i].inlier_keys.size(); ++p) {
      const std::vector<std::uint64_t>& keys = results[i].inlier_keys[p];
      std::map<std::uint32_t, std::size_t> counts;
      for (const std::uint64_t key : keys) {
        if (const std::uint32_t label = first.of(key); label != 0) ++counts[label];
      }
      PlanePoints& points = lines[i]->planes[p].points;
      points = {keys.size(), {}};
      for (const auto& [label, n] : counts) {
        const auto [line, plane] = planes[label - 1];
        points.shared.push_back({line, plane, n});
      }
      planes.emplace_back(i, p);
      const auto number = static_cast<std::uint32_t>(planes.size());
      for (const std::uint64_t key : keys) first.add(key, number);
    }
  }
}

void identify_planes(std::span<LineEvaluation* const> lines) {
  const std::vector<std::size_t> order = judged_by_place(lines);
  for (const std::size_t i : order) {
    for (JudgingPlane& plane : lines[i]->planes) plane.id = 0;
  }
  std::uint64_t n_planes = 0;
  for (const std::size_t i : order) {
    for (JudgingPlane& plane : lines[i]->planes) {
      const std::uint64_t id = common_id(plane.points, lines);
      plane.id = id != 0 ? id : ++n_planes;
    }
  }
}

}  // namespace ridgeline::evaluate
