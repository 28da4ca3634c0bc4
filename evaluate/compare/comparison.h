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

/// With a smaller share, the pairs are a selection of the lines for which a test is not meaningful.
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
  /// Number of lines, and of those that are closer to their planes in B than in A, unchanged within
  /// 1 mm, and farther away.
  std::size_t n = 0, n_improved = 0, n_unchanged = 0, n_worse = 0;
  std::size_t n_clusters = 0;
  std::optional<double> rms_a_m, rms_b_m;
  std::optional<double> rms_ratio;                        ///< B / A; empty if A's is 0
  std::optional<double> rms_gain_m;                       ///< A - B
  std::optional<Interval> rms_ratio_ci95, rms_gain_ci95;  ///< clustered bootstrap
  std::optional<double> median_gain_m;                    ///< of a_m - b_m
  /// For a_m - b_m; empty if the pairs of all classes are less than kMinPairedShare of the lines of
  /// the smaller side.
  std::optional<double> wilcoxon_p;
};

/// Upper limits of the distance classes in which lines without a partner are counted, m; one more
/// class lies above them.
inline constexpr std::array kAloneUpTo_m{0.05, 0.1, 0.3, 1.0};
using CountsByDistance = std::array<std::size_t, kAloneUpTo_m.size() + 1>;

/// A comparison of two judgements whose lines are paired by id or in space.
struct Comparison {
  std::string patch;
  std::string name_a, name_b;
  bool in_space = false;
  /// The number of views that each side used, if they differ.
  std::optional<std::size_t> n_views_a, n_views_b;
  std::size_t n_common = 0;                ///< evaluated in both
  std::size_t n_only_a = 0, n_only_b = 0;  ///< evaluated in one; they only affect coverage
  CountsByDistance only_a{}, only_b{};     ///< n_only_a and n_only_b by judged distance
  std::vector<PairedSummary> classes;      ///< not_aligned, aligned, total; or only total
  std::vector<PairedLine> worst;           ///< up to 10 lines that worsened most from A to B
  std::vector<Summary> own_a, own_b;       ///< each on its own lines, as in published tables
  /// Number of not_aligned lines on which direct and joint differ. Both use the same code for these
  /// lines unless joint adjusts them to faces, so every such line indicates a defect. Empty for
  /// other pairs of methods, if joint adjusts lines to faces, and if lines were moved before they
  /// were judged.
  std::optional<std::size_t> n_not_aligned_differing;
};

/// Compares B with A. Uses the clusters and options of A. `joint_adjusts_to_faces`: see Table2.
Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces = false);

/// Compares B with A if their ids do not correspond: pairs lines by position, see pair_in_space(),
/// and uses the class of each line in the base pair.
Comparison compare_in_space(const Evaluation& a,
                            const Evaluation& b,
                            std::string name_a,
                            std::string name_b);

struct ComparisonReport {
  std::vector<Comparison> comparisons;
  std::vector<std::string> warnings;  ///< evaluations without counterpart, different inputs
};

/// Compares each folder with the first one. Evaluations of the same patch and method are paired. If
/// both folders have exactly one evaluation of a patch, the two are paired regardless of their
/// methods. compare_in_space() is used, unless both folders recorded the same segments, matches and
/// number of views, which determine the line numbers, or one of them did not record the positions
/// of its lines. Throws std::invalid_argument for fewer than two folders or if nothing can be
/// paired.
ComparisonReport compare_folders(std::span<const ResultFolder> folders);

/// Compares the methods of one folder, each with the first method of its patch: line files in
/// space, methods of a run by id.
std::vector<Comparison> compare_methods(const ResultFolder& folder);

/// A figure of all lines that is worse in B than in A.
struct WorseFigure {
  std::string patch, name_a, name_b;
  double a = 0.0;
  std::optional<double> b;
};

/// The comparisons in which a figure of all lines is worse in B than in A by more than the margin.
/// A figure that only A has counts as worse.
std::vector<WorseFigure> worse_figures(
    const ComparisonReport& report,
    const std::function<std::optional<double>(const Summary&)>& figure,
    bool more_is_better,
    double margin);

/// The report as Markdown: for each comparison a table of the common lines, one of each side's own
/// lines and one of the worst lines; then the warnings.
std::string to_markdown(const ComparisonReport& report);
std::string to_terminal(const ComparisonReport& report);  ///< the report in aligned columns

std::string to_json(const ComparisonReport& report);

}  // namespace ridgeline::evaluate
