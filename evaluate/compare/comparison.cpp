// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/comparison.h"

#include "evaluate/compare/wilcoxon.h"
#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ridgeline::evaluate {
namespace {

/// The common lines, with the cluster of each.
struct Pairs {
  std::vector<PairedLine> lines;
  std::vector<std::size_t> clusters;
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

Pairs pair_lines(const Evaluation& a, const LineById& b_by_id) {
  Pairs pairs;
  const std::vector<std::size_t> labels = cluster_labels(a.lines);
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const LineEvaluation& line = a.lines[i];
    const auto found = b_by_id.find(line.id);
    if (line.status != Status::kEvaluated || found == b_by_id.end()) continue;
    const LineEvaluation& other = *found->second;
    pairs.lines.push_back({line.id,
                           is_classed(line.line_class) ? line.line_class : other.line_class,
                           line.mean_distance_m, other.mean_distance_m});
    pairs.clusters.push_back(labels[i]);
  }
  return pairs;
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
  const auto n = static_cast<double>(summary.n);
  summary.rms_a_m = std::sqrt(sum_of_squares(a_m) / n);
  summary.rms_b_m = std::sqrt(sum_of_squares(b_m) / n);
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

const Evaluation* counterpart(const Evaluation& e,
                              const ResultFolder& of,
                              const ResultFolder& other) {
  const auto of_patch = [&](const Evaluation& x) { return x.patch == e.patch; };
  const auto same =
      std::find_if(other.evaluations.begin(), other.evaluations.end(),
                   [&](const Evaluation& x) { return x.patch == e.patch && x.method == e.method; });
  if (same != other.evaluations.end()) return &*same;
  const bool single =
      std::count_if(of.evaluations.begin(), of.evaluations.end(), of_patch) == 1 &&
      std::count_if(other.evaluations.begin(), other.evaluations.end(), of_patch) == 1;
  if (!single) return nullptr;
  return &*std::find_if(other.evaluations.begin(), other.evaluations.end(), of_patch);
}

/// Whether `joint` may have adjusted lines to faces. It is taken to have done so in a run whose options are not known,
/// so that a difference from direct is no sign of a defect there.
bool may_adjust_to_faces(const ResultFolder& folder) {
  return folder.joint_adjusts_to_faces.value_or(true);
}

void compare_with_first(const ResultFolder& first,
                        const ResultFolder& other,
                        ComparisonReport& report) {
  if (first.input_hashes != other.input_hashes) {
    report.warnings.push_back(other.name + ": its input hashes differ from those of " + first.name +
                              "; differences of the data are in the figures");
  }
  for (const Evaluation& a : first.evaluations) {
    const Evaluation* b = counterpart(a, first, other);
    if (b == nullptr) {
      report.warnings.push_back(other.name + ": nothing to compare with patch " + a.patch + ", " +
                                a.method + " of " + first.name);
      continue;
    }
    report.comparisons.push_back(compare(a, *b, first.name + " " + a.method,
                                         other.name + " " + b->method,
                                         may_adjust_to_faces(first) || may_adjust_to_faces(other)));
  }
}

}  // namespace

Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces) {
  const LineById a_by_id = evaluated_by_id(a);
  const LineById b_by_id = evaluated_by_id(b);
  const Pairs pairs = pair_lines(a, b_by_id);
  Comparison result;
  result.patch = a.patch;
  result.name_a = std::move(name_a);
  result.name_b = std::move(name_b);
  result.n_common = pairs.lines.size();
  result.n_only_a = a_by_id.size() - pairs.lines.size();
  result.n_only_b = b_by_id.size() - pairs.lines.size();
  result.classes = summarize_pair_classes(pairs, a.options.bootstrap);
  result.worst = worst_lines(pairs.lines);
  result.own_a = a.classes;
  result.own_b = b.classes;
  if (!joint_adjusts_to_faces && is_direct_and_joint(a.method, b.method)) {
    result.n_not_aligned_differing = count_differing(a_by_id, b_by_id);
  }
  return result;
}

ComparisonReport compare_folders(std::span<const ResultFolder> folders) {
  check(folders.size() >= 2, "compare: ", folders.size(), " result folder; at least 2 are needed");
  ComparisonReport report;
  for (const ResultFolder& other : folders.subspan(1)) {
    compare_with_first(folders.front(), other, report);
  }
  check(!report.comparisons.empty(), "compare: no patch of ", folders.front().name,
        " has a counterpart; folders must share a patch and a method");
  return report;
}

std::vector<Comparison> compare_methods(const ResultFolder& folder) {
  std::map<std::string, const Evaluation*> first_of_patch;
  std::vector<Comparison> result;
  for (const Evaluation& e : folder.evaluations) {
    const Evaluation* first = first_of_patch.try_emplace(e.patch, &e).first->second;
    if (first == &e) continue;
    result.push_back(compare(*first, e, first->method, e.method, may_adjust_to_faces(folder)));
  }
  return result;
}

}  // namespace ridgeline::evaluate
