// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/decoy_figures.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ridgeline::evaluate {
namespace {

std::optional<double> part_of(std::size_t n, std::size_t of) {
  if (of == 0) return std::nullopt;
  return static_cast<double>(n) / static_cast<double>(of);
}

bool is_evaluated(const LineEvaluation& line) { return line.status == Status::kEvaluated; }

bool passes(const LineEvaluation& line) {
  return is_evaluated(line) && line.mean_distance_m < kRight_m;
}

/// Interval of the share of decoys that pass, where `passed[i]` belongs to cluster `clusters[i]`.
std::optional<Interval> share_interval(const std::vector<char>& passed,
                                       const std::vector<std::size_t>& clusters,
                                       const BootstrapOptions& options) {
  // For zeros and ones, the root mean square is the root of the share.
  const std::vector<double> ones(passed.begin(), passed.end());
  const auto n_passed = static_cast<std::size_t>(std::ranges::count(passed, 1));
  std::optional<Interval> interval = wilson_interval(n_passed, passed.size(), options.level);
  const std::optional<Interval> of_root = bootstrap_rms(ones, clusters, options);
  if (!interval || !of_root) return interval;
  return Interval{std::min(interval->low, of_root->low * of_root->low),
                  std::max(interval->high, of_root->high * of_root->high)};
}

DecoyFigure figure_of(std::span<const JudgedDecoy* const> decoys,
                      std::span<const std::size_t> clusters,
                      const BootstrapOptions& options) {
  DecoyFigure figure;
  figure.kind = decoys.front()->decoy.kind;
  figure.distance_m = decoys.front()->decoy.distance_m;
  std::set<std::size_t> parents;
  std::vector<char> passed;
  std::vector<std::size_t> labels;
  for (const JudgedDecoy* judged : decoys) {
    parents.insert(judged->decoy.parent);
    labels.push_back(clusters[judged->decoy.parent]);
    passed.push_back(passes(judged->evaluation) ? 1 : 0);
    if (!is_evaluated(judged->evaluation)) ++figure.n_withheld;
  }
  figure.n_lines = parents.size();
  figure.n_decoys = decoys.size();
  figure.n_passed = static_cast<std::size_t>(std::ranges::count(passed, 1));
  figure.n_clusters = count_clusters(labels);
  figure.ci95 = share_interval(passed, labels, options);
  return figure;
}

}  // namespace

std::optional<double> DecoyFigure::share() const { return part_of(n_passed, n_decoys); }

std::optional<double> DecoyFigure::withheld_share() const { return part_of(n_withheld, n_decoys); }

std::vector<DecoyFigure> decoy_figures(std::span<const JudgedDecoy> decoys,
                                       std::span<const LineEvaluation> lines,
                                       const BootstrapOptions& options) {
  for (const JudgedDecoy& judged : decoys) {
    check(judged.decoy.parent < lines.size(), "decoy_figures: decoy of line ", judged.decoy.parent,
          " of ", lines.size(), ", must be one of them");
  }
  const std::vector<std::size_t> clusters = cluster_labels(lines);
  std::vector<DecoyFigure> figures;
  for (const DecoyKind kind : kDecoyKinds) {
    for (const double distance_m : kDecoyDistances_m) {
      std::vector<const JudgedDecoy*> members;
      for (const JudgedDecoy& judged : decoys) {
        const Decoy& d = judged.decoy;
        if (d.kind == kind && d.distance_m == distance_m && is_evaluated(lines[d.parent]))
          members.push_back(&judged);
      }
      if (!members.empty()) figures.push_back(figure_of(members, clusters, options));
    }
  }
  return figures;
}

}  // namespace ridgeline::evaluate
