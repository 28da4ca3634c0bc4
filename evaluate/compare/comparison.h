// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/result_folder.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// One line evaluated in both A and B.
struct PairedLine {
  std::string id, line_class;
  double a_m = 0.0, b_m = 0.0;  ///< mean |distance| to its planes
  /// Positive if B is closer to the planes.
  [[nodiscard]] double gain_m() const { return a_m - b_m; }
};

/// The paired figures of a class.
struct PairedSummary {
  std::string line_class;
  /// Number of lines, and of those that B has closer to their planes, unchanged within 1 mm and farther off than A.
  std::size_t n = 0, n_improved = 0, n_unchanged = 0, n_worse = 0;
  std::size_t n_clusters = 0;
  std::optional<double> rms_a_m, rms_b_m;
  std::optional<double> rms_ratio;                        ///< B / A; empty if A's is 0
  std::optional<double> rms_gain_m;                       ///< A - B
  std::optional<Interval> rms_ratio_ci95, rms_gain_ci95;  ///< clustered bootstrap
  std::optional<double> median_gain_m;                    ///< of a_m - b_m
  std::optional<double> wilcoxon_p;                       ///< of a_m - b_m
};

/// Two judgements of the same lines, paired by line id, or in space.
struct Comparison {
  std::string patch;
  std::string name_a, name_b;
  /// The number of views that each side used, if it differs: the lines are then paired in space.
  std::optional<std::size_t> n_views_a, n_views_b;
  std::size_t n_common = 0;                ///< evaluated in both
  std::size_t n_only_a = 0, n_only_b = 0;  ///< evaluated in one; they count in coverage alone
  std::vector<PairedSummary> classes;      ///< not_aligned, aligned, total; or total alone
  std::vector<PairedLine> worst;           ///< up to 10 lines that lost most from A to B
  std::vector<Summary> own_a, own_b;       ///< each on its own lines, as published tables are
  /// Number of not_aligned lines on which direct and joint differ. They solve these lines by the same
  /// code unless joint adjusts them to faces, so every such line shows a defect. Empty for other pairs
  /// of methods, if joint adjusts lines to faces, and if lines were moved before they were judged.
  std::optional<std::size_t> n_not_aligned_differing;
};

/// Compares B with A. Clusters and options are those of A. `joint_adjusts_to_faces`: see Table2.
Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces = false);

/// Compares B with A if they reconstructed one patch from different numbers of views. Their lines are other lines with
/// other ids, so they are paired where they lie, see pair_in_space(), and every class is that of the base pair.
Comparison compare_in_space(const Evaluation& a,
                            const Evaluation& b,
                            std::string name_a,
                            std::string name_b);

struct ComparisonReport {
  std::vector<Comparison> comparisons;
  std::vector<std::string> warnings;  ///< evaluations without counterpart, different inputs
};

/// Compares each folder with the first one. Evaluations of the same patch and method are paired. If
/// both folders have exactly one evaluation of a patch, the two are paired whatever their methods are
/// called. Where the folders recorded different numbers of views of a patch, compare_in_space() compares them.
/// Throws std::invalid_argument for fewer than two folders or if nothing can be paired.
ComparisonReport compare_folders(std::span<const ResultFolder> folders);

/// Compares the methods of one folder, each with the first method of its patch.
std::vector<Comparison> compare_methods(const ResultFolder& folder);

/// The report as Markdown: for each comparison a table on the common lines, one on the own lines of either side and one
/// of the worst lines; then the warnings.
std::string to_markdown(const ComparisonReport& report);
std::string to_terminal(const ComparisonReport& report);  ///< the report in aligned columns

std::string to_json(const ComparisonReport& report);

}  // namespace ridgeline::evaluate
