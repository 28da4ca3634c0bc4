// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/batch_judge.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace ridgeline::evaluate {
namespace {

std::vector<char> repeated_ids(std::span<const JudgedLine> lines) {
  std::unordered_set<std::string> seen;
  std::vector<char> repeated(lines.size(), 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    repeated[i] = seen.insert(lines[i].id).second && !lines[i].repeats_id ? 0 : 1;
  }
  return repeated;
}

JudgedResult duplicate(const JudgedLine& line) {
  JudgedResult result;
  result.evaluation.id = line.id;
  result.evaluation.line_class = line.line_class;
  result.evaluation.building = line.building;
  result.evaluation.epipolar_angle_deg = line.epipolar_angle_deg;
  result.evaluation.n_images = line.n_images;
  result.evaluation.class_base = line.class_base;
  if (line.n_images && in_range(line.segment)) result.evaluation.segment = line.segment;
  result.evaluation.status = Status::kDuplicateId;
  result.evaluation.reason = "an earlier line has the same id";
  if (in_range(line.segment)) result.evaluation.length_m = length(line.segment);
  return result;
}

/// Labels of points by their keys, in a table with open addressing: a cloud has millions of points,
/// and their keys are hashes already.
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

  /// The slot where the key is, or would be put.
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

/// The label that most of a plane's labelled points carry, if that is a good part of all its
/// points; else 0.
std::uint32_t common_label(const std::vector<std::uint64_t>& inliers, const PointLabels& labels) {
  constexpr double kShared = 0.3;  // neighbouring facets share only the points at their edge
  std::unordered_map<std::uint32_t, std::size_t> votes;
  for (const std::uint64_t key : inliers) {
    const std::uint32_t label = labels.of(key);
    if (label != 0) ++votes[label];
  }
  std::uint32_t best = 0;
  std::size_t most = 0;
  for (const auto& [label, count] : votes) {
    if (count > most || (count == most && label < best)) {
      best = label;
      most = count;
    }
  }
  return static_cast<double>(most) >= kShared * static_cast<double>(inliers.size()) ? best : 0;
}

std::array<double, 3> key_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

/// The numbers of the lines that planes judged, by their place: nothing may depend on the order of
/// a file.
std::vector<std::size_t> judged_by_place(std::span<const JudgedLine> lines,
                                         const std::vector<JudgedResult>& results) {
  const auto place = [&](std::size_t i) {
    const auto [first, last] =
        std::minmax({key_of(lines[i].segment.start), key_of(lines[i].segment.end)});
    return std::pair(first, last);
  };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].inlier_keys.empty()) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, place);
  return order;
}

/// Gives planes that were fitted to the same points one id, in the order of the lines' places.
void identify_planes(std::span<const JudgedLine> lines, std::vector<JudgedResult>& results) {
  PointLabels labels;
  std::uint32_t next = 1;
  for (const std::size_t i : judged_by_place(lines, results)) {
    JudgedResult& result = results[i];
    for (std::size_t p = 0; p < result.inlier_keys.size(); ++p) {
      std::uint32_t label = common_label(result.inlier_keys[p], labels);
      if (label == 0) label = next++;
      for (const std::uint64_t key : result.inlier_keys[p]) labels.add(key, label);
      result.evaluation.planes[p].id = label;
    }
  }
}

}  // namespace

BatchJudge::BatchJudge(std::span<const JudgedLine> lines, const JudgeOptions& options)
    : lines_(lines), options_(options), repeated_(repeated_ids(lines)), results_(lines.size()) {
  validate(options);
}

void BatchJudge::judge(const PointSearch& search, std::span<const std::size_t> batch) {
  tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t k) {
    Interruption::check();
    const std::size_t i = batch[k];
    results_[i] =
        repeated_[i] != 0 ? duplicate(lines_[i]) : judge_line(search, lines_[i], options_);
  });
}

std::vector<JudgedResult> BatchJudge::take_results() {
  identify_planes(lines_, results_);
  return std::move(results_);
}

std::vector<JudgedResult> BatchJudge::take_without_ids() { return std::move(results_); }

}  // namespace ridgeline::evaluate
