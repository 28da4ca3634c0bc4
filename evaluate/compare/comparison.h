// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/result_folder.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Fewer pairs are a choice of the lines, of which no test says anything.
inline constexpr double kMinPairedShare = 0.8;

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
  /// Number of lines, and of those that B has closer to their planes, unchanged within 1 mm and
  /// farther off than A.
  std::size_t n = 0, n_improved = 0, n_unchanged = 0, n_worse = 0;
  std::size_t n_clusters = 0;
  std::optional<double> rms_a_m, rms_b_m;
  std::optional<double> rms_ratio;                        ///< B / A; empty if A's is 0
  std::optional<double> rms_gain_m;                       ///< A - B
  std::optional<Interval> rms_ratio_ci95, rms_gain_ci95;  ///< clustered bootstrap
  std::optional<double> median_gain_m;                    ///< of a_m - b_m
  /// Of a_m - b_m; empty if the pairs of all classes are less than kMinPairedShare of the smaller
  /// side's lines.
  std::optional<double> wilcoxon_p;
};

/// Upper ends of the classes of distance in which lines without a partner are counted, m; there is
/// one more above them.
inline constexpr std::array kAloneUpTo_m{0.05, 0.1, 0.3, 1.0};
using CountsByDistance = std::array<std::size_t, kAloneUpTo_m.size() + 1>;

/// Two judgements, whose lines are paired by their ids or in space.
struct Comparison {
  std::string patch;
  std::string name_a, name_b;
  bool in_space = false;
  /// The number of views that each side used, if it differs.
  std::optional<std::size_t> n_views_a, n_views_b;
  std::size_t n_common = 0;                ///< evaluated in both
  std::size_t n_only_a = 0, n_only_b = 0;  ///< evaluated in one; they count in coverage alone
  CountsByDistance only_a{}, only_b{};     ///< the same by judged distance
  std::vector<PairedSummary> classes;      ///< not_aligned, aligned, total; or total alone
  std::vector<PairedLine> worst;           ///< up to 10 lines that lost most from A to B
  std::vector<Summary> own_a, own_b;       ///< each on its own lines, as published tables are
  /// Number of not_aligned lines on which direct and joint differ. They solve these lines by the
  /// same code unless joint adjusts them to faces, so every such line shows a defect. Empty for
  /// other pairs of methods, if joint adjusts lines to faces, and if lines were moved before they
  /// were judged.
  std::optional<std::size_t> n_not_aligned_differing;
};

/// Compares B with A. Clusters and options are those of A. `joint_adjusts_to_faces`: see Table2.
Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces = false);

/// Compares B with A where ids do not mean the same: lines are paired where they lie, see
/// pair_in_space(), and every class is that of the base pair.
Comparison compare_in_space(const Evaluation& a,
                            const Evaluation& b,
                            std::string name_a,
                            std::string name_b);

struct ComparisonReport {
  std::vector<Comparison> comparisons;
  std::vector<std::string> warnings;  ///< evaluations without counterpart, different inputs
};

/// Compares each folder with the first one. Evaluations of the same patch and method are paired. If
/// both folders have exactly one evaluation of a patch, the two are paired whatever their methods
/// are called. compare_in_space() compares them, unless both recorded the same segments, matches
/// and number of views, which number the lines, or one does not know where its lines lie. Throws
/// std::invalid_argument for fewer than two folders or if nothing can be paired.
ComparisonReport compare_folders(std::span<const ResultFolder> folders);

/// Compares the methods of one folder, each with the first method of its patch: files of lines in
/// space, methods of a run by ids.
std::vector<Comparison> compare_methods(const ResultFolder& folder);

/// A figure of all lines of B that is worse than that of A.
struct WorseFigure {
  std::string patch, name_a, name_b;
  double a = 0.0;
  std::optional<double> b;
};

/// Where a figure of all lines is worse in B than in A by more than the margin; of each comparison.
/// A figure that B lacks and A has is worse.
std::vector<WorseFigure> worse_figures(
    const ComparisonReport& report,
    const std::function<std::optional<double>(const Summary&)>& figure,
    bool more_is_better,
    double margin);

/// The report as Markdown: for each comparison a table on the common lines, one on the own lines of
/// either side and one of the worst lines; then the warnings.
std::string to_markdown(const ComparisonReport& report);
std::string to_terminal(const ComparisonReport& report);  ///< the report in aligned columns

std::string to_json(const ComparisonReport& report);

}  // namespace ridgeline::evaluate
