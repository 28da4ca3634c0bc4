// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/comparison.h"

#include "evaluate/compare/pair_in_space.h"
#include "evaluate/compare/wilcoxon.h"
#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/product_method.h"
#include "evaluate/tables/shift_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace ridgeline::evaluate {
namespace {

/// The common lines and their clusters.
struct Pairs {
  std::vector<PairedLine> lines;
  std::vector<std::size_t> clusters;
  std::vector<std::size_t> members_a, members_b;  ///< indices in each evaluation
};

using LineById = std::map<std::string, const LineEvaluation*>;

LineById evaluated_by_id(const Evaluation& evaluation) {
  LineById result;
  for (const LineEvaluation& line : evaluation.lines) {
    if (line.status == Status::kEvaluated) result.emplace(line.id, &line);
  }
  return result;
}

bool is_classed(const std::string& line_class) {
  return line_class == kAligned || line_class == kNotAligned;
}

void add_pair(
    const Evaluation& a, std::size_t i, const Evaluation& b, std::size_t k, Pairs& pairs) {
  const LineEvaluation& line = a.lines[i];
  const LineEvaluation& other = b.lines[k];
  pairs.lines.push_back({line.id, is_classed(line.line_class) ? line.line_class : other.line_class,
                         *line.mean_distance_m, *other.mean_distance_m});
  pairs.members_a.push_back(i);
  pairs.members_b.push_back(k);
}

/// Adds the clusters of A to the pairs.
Pairs with_clusters(Pairs pairs, const Evaluation& a) {
  const std::vector<std::size_t> labels = cluster_labels(a.lines);
  for (const std::size_t i : pairs.members_a) pairs.clusters.push_back(labels[i]);
  return pairs;
}

Pairs pair_lines(const Evaluation& a, const Evaluation& b) {
  const LineById b_by_id = evaluated_by_id(b);
  Pairs pairs;
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const auto found = b_by_id.find(a.lines[i].id);
    if (a.lines[i].status != Status::kEvaluated || found == b_by_id.end()) continue;
    add_pair(a, i, b, static_cast<std::size_t>(found->second - b.lines.data()), pairs);
  }
  return with_clusters(std::move(pairs), a);
}

/// The evaluated lines with known positions.
struct PlacedLines {
  std::vector<std::size_t> members;
  std::vector<Segment3> segments;
};

PlacedLines placed_lines(const Evaluation& e, const Eigen::Vector3d& origin_m) {
  PlacedLines placed;
  const Eigen::Vector3d shift_m = e.origin_m - origin_m;
  for (std::size_t i = 0; i < e.lines.size(); ++i) {
    const LineEvaluation& line = e.lines[i];
    if (line.status != Status::kEvaluated || !line.segment) continue;
    placed.members.push_back(i);
    placed.segments.push_back({line.segment->start + shift_m, line.segment->end + shift_m});
  }
  return placed;
}

Pairs pair_lines_in_space(const Evaluation& a, const Evaluation& b) {
  const PlacedLines of_a = placed_lines(a, a.origin_m);
  const PlacedLines of_b = placed_lines(b, a.origin_m);
  Pairs pairs;
  for (const auto& pair : pair_in_space(of_a.segments, of_b.segments)) {
    add_pair(a, of_a.members[pair.first], b, of_b.members[pair.second], pairs);
  }
  return with_clusters(std::move(pairs), a);
}

/// Uses the class in the base pair for each line that has one.
Evaluation with_base_classes(Evaluation e) {
  for (LineEvaluation& line : e.lines) {
    if (!line.class_base.empty()) line.line_class = line.class_base;
  }
  return with_summaries(std::move(e));
}

Pairs of_class(const Pairs& pairs, std::string_view line_class) {
  Pairs result;
  for (std::size_t i = 0; i < pairs.lines.size(); ++i) {
    if (pairs.lines[i].line_class != line_class) continue;
    result.lines.push_back(pairs.lines[i]);
    result.clusters.push_back(pairs.clusters[i]);
  }
  return result;
}

struct ClusterSums {
  double a = 0.0, b = 0.0, n = 0.0;  ///< sums of squares, number of lines
};

std::vector<ClusterSums> sums_per_cluster(const Pairs& pairs) {
  const std::vector<std::size_t> labels = dense_labels(pairs.clusters);
  std::vector<ClusterSums> sums(count_clusters(labels));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ClusterSums& s = sums[labels[i]];
    s.a += pairs.lines[i].a_m * pairs.lines[i].a_m;
    s.b += pairs.lines[i].b_m * pairs.lines[i].b_m;
    s.n += 1.0;
  }
  return sums;
}

ClusterSums total_of(const std::vector<ClusterSums>& sums, std::span<const std::size_t> drawn) {
  ClusterSums total;
  for (const std::size_t i : drawn) {
    total.a += sums[i].a;
    total.b += sums[i].b;
    total.n += sums[i].n;
  }
  return total;
}

void describe_intervals(const Pairs& pairs,
                        const BootstrapOptions& options,
                        PairedSummary& summary) {
  const std::vector<ClusterSums> sums = sums_per_cluster(pairs);
  summary.n_clusters = sums.size();
  const auto ratio = [&](std::span<const std::size_t> drawn) {
    const ClusterSums t = total_of(sums, drawn);
    return std::sqrt(t.b / t.a);
  };
  const auto gain = [&](std::span<const std::size_t> drawn) {
    const ClusterSums t = total_of(sums, drawn);
    return std::sqrt(t.a / t.n) - std::sqrt(t.b / t.n);
  };
  if (summary.rms_ratio) {
    summary.rms_ratio_ci95 = clustered_bootstrap(sums.size(), ratio, options);
  }
  summary.rms_gain_ci95 = clustered_bootstrap(sums.size(), gain, options);
}

void count_changes(const Pairs& pairs, PairedSummary& summary) {
  constexpr double kUnchangedM = 0.001;
  for (const PairedLine& line : pairs.lines) {
    if (std::abs(line.gain_m()) < kUnchangedM) {
      ++summary.n_unchanged;
    } else {
      ++(line.gain_m() > 0.0 ? summary.n_improved : summary.n_worse);
    }
  }
}

/// Removes the lines without a visible edge; the figures remain those of all lines.
Evaluation of_edges(Evaluation e) {
  std::erase_if(e.lines,
                [&](const LineEvaluation& line) { return is_of_planes(e.method, line.id); });
  return e;
}

PairedSummary summarize_pairs(const Pairs& pairs,
                              std::string_view line_class,
                              const BootstrapOptions& options) {
  PairedSummary summary;
  summary.line_class = line_class;
  summary.n = pairs.lines.size();
  if (pairs.lines.empty()) return summary;
  std::vector<double> a_m;
  std::vector<double> b_m;
  std::vector<double> gains_m;
  for (const PairedLine& line : pairs.lines) {
    a_m.push_back(line.a_m);
    b_m.push_back(line.b_m);
    gains_m.push_back(line.gain_m());
  }
  summary.rms_a_m = rms(a_m);
  summary.rms_b_m = rms(b_m);
  summary.rms_gain_m = *summary.rms_a_m - *summary.rms_b_m;
  if (*summary.rms_a_m > 0.0) summary.rms_ratio = *summary.rms_b_m / *summary.rms_a_m;
  summary.median_gain_m = median(gains_m);
  summary.wilcoxon_p = wilcoxon_signed_rank_p(gains_m);
  count_changes(pairs, summary);
  describe_intervals(pairs, options, summary);
  return summary;
}

std::vector<PairedSummary> summarize_pair_classes(const Pairs& pairs,
                                                  const BootstrapOptions& options) {
  std::vector<PairedSummary> result;
  const bool classed = std::any_of(pairs.lines.begin(), pairs.lines.end(),
                                   [](const PairedLine& l) { return is_classed(l.line_class); });
  if (classed) {
    for (const std::string_view c : {kNotAligned, kAligned}) {
      result.push_back(summarize_pairs(of_class(pairs, c), c, options));
    }
  }
  result.push_back(summarize_pairs(pairs, kTotal, options));
  return result;
}

std::vector<PairedLine> worst_lines(std::vector<PairedLine> lines) {
  constexpr std::size_t kNumWorst = 10;
  std::erase_if(lines, [](const PairedLine& l) { return l.gain_m() >= 0.0; });
  std::sort(lines.begin(), lines.end(), [](const PairedLine& l, const PairedLine& r) {
    return l.gain_m() != r.gain_m() ? l.gain_m() < r.gain_m() : l.id < r.id;
  });
  if (lines.size() > kNumWorst) lines.resize(kNumWorst);
  return lines;
}

bool is_direct_and_joint(const std::string& a, const std::string& b) {
  return (a == "direct" && b == "joint") || (a == "joint" && b == "direct");
}

std::size_t count_differing(const LineById& a, const LineById& b) {
  std::size_t n = 0;
  for (const auto& [id, line] : a) {
    if (line->line_class != kNotAligned) continue;
    const auto found = b.find(id);
    const bool equal = found != b.end() && found->second->mean_distance_m == line->mean_distance_m;
    if (!equal) ++n;
  }
  for (const auto& [id, line] : b) {
    if (line->line_class == kNotAligned && !a.contains(id)) ++n;
  }
  return n;
}

/// Counts the unpaired evaluated lines by distance.
CountsByDistance alone(const Evaluation& e, std::span<const std::size_t> paired) {
  const std::set<std::size_t> has_partner(paired.begin(), paired.end());
  CountsByDistance counts{};
  for (std::size_t i = 0; i < e.lines.size(); ++i) {
    if (e.lines[i].status != Status::kEvaluated || has_partner.contains(i)) continue;
    const auto above = std::ranges::lower_bound(kAloneUpTo_m, *e.lines[i].mean_distance_m);
    ++counts[static_cast<std::size_t>(above - kAloneUpTo_m.begin())];
  }
  return counts;
}

std::size_t sum_of(const CountsByDistance& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

Comparison comparison_of(const Evaluation& a,
                         const Evaluation& b,
                         const Pairs& pairs,
                         std::string name_a,
                         std::string name_b) {
  Comparison result;
  result.patch = a.patch;
  result.name_a = std::move(name_a);
  result.name_b = std::move(name_b);
  result.n_common = pairs.lines.size();
  result.only_a = alone(a, pairs.members_a);
  result.only_b = alone(b, pairs.members_b);
  result.n_only_a = sum_of(result.only_a);
  result.n_only_b = sum_of(result.only_b);
  result.classes = summarize_pair_classes(pairs, a.options.bootstrap);
  const double n_smaller =
      static_cast<double>(result.n_common + std::min(result.n_only_a, result.n_only_b));
  if (static_cast<double>(result.n_common) < kMinPairedShare * n_smaller) {
    for (PairedSummary& summary : result.classes) summary.wilcoxon_p.reset();
  }
  result.worst = worst_lines(pairs.lines);
  result.own_a = a.classes;
  result.own_b = b.classes;
  return result;
}

}  // namespace

Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces) {
  const Evaluation edges_a = of_edges(a);
  const Evaluation edges_b = of_edges(b);
  Comparison result = comparison_of(edges_a, edges_b, pair_lines(edges_a, edges_b),
                                    std::move(name_a), std::move(name_b));
  const bool is_moved =
      !moved_note(a).empty() || !moved_note(b).empty();  // each side by its own shift
  if (!joint_adjusts_to_faces && !is_moved && is_direct_and_joint(a.method, b.method)) {
    result.n_not_aligned_differing = count_differing(evaluated_by_id(a), evaluated_by_id(b));
  }
  return result;
}

Comparison compare_in_space(const Evaluation& a,
                            const Evaluation& b,
                            std::string name_a,
                            std::string name_b) {
  const Evaluation base_a = with_base_classes(a);
  const Evaluation base_b = with_base_classes(b);
  Comparison result = comparison_of(base_a, base_b, pair_lines_in_space(base_a, base_b),
                                    std::move(name_a), std::move(name_b));
  result.in_space = true;
  return result;
}

}  // namespace ridgeline::evaluate
