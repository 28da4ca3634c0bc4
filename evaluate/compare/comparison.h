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
  /// Positive: B is closer.
  [[nodiscard]] double gain_m() const { return a_m - b_m; }
};

/// The paired figures of a class.
struct PairedSummary {
  std::string line_class;
  std::size_t n = 0, n_improved = 0, n_unchanged = 0, n_worse = 0;  ///< of B over A; 1 mm is equal
  std::size_t n_clusters = 0;
  std::optional<double> rms_a_m, rms_b_m;
  std::optional<double> rms_ratio;                        ///< B / A; empty if A's is 0
  std::optional<double> rms_gain_m;                       ///< A - B
  std::optional<Interval> rms_ratio_ci95, rms_gain_ci95;  ///< clustered bootstrap
  std::optional<double> median_gain_m;                    ///< of a_m - b_m
  std::optional<double> wilcoxon_p;                       ///< of a_m - b_m
};

/// Two judgements of the same lines, paired by line id.
struct Comparison {
  std::string patch;
  std::string name_a, name_b;
  std::size_t n_common = 0;                ///< evaluated in both
  std::size_t n_only_a = 0, n_only_b = 0;  ///< evaluated in one; they count in coverage alone
  std::vector<PairedSummary> classes;      ///< not_aligned, aligned, total; or total alone
  std::vector<PairedLine> worst;           ///< up to 10 lines that lost most from A to B
  std::vector<Summary> own_a, own_b;       ///< each on its own lines, as published tables are
  /// direct and joint solve not_aligned lines by the same code, unless joint adjusts them to faces:
  /// lines of that class whose result nevertheless differs. Any is a defect. Empty for other pairs of
  /// methods, and where the code is not the same.
  std::optional<std::size_t> n_not_aligned_differing;
};

/// Compares B with A. Clusters are A's; the options are A's. `joint_adjusts_to_faces`: see Table2.
Comparison compare(const Evaluation& a,
                   const Evaluation& b,
                   std::string name_a,
                   std::string name_b,
                   bool joint_adjusts_to_faces = false);

struct ComparisonReport {
  std::vector<Comparison> comparisons;
  std::vector<std::string> warnings;  ///< evaluations without counterpart, different inputs
};

/// Each folder against the first: evaluations of the same patch and method, and where a patch has
/// one evaluation in either folder, these whatever their methods are called.
/// Throws std::invalid_argument for fewer than two folders or if nothing can be paired.
ComparisonReport compare_folders(std::span<const ResultFolder> folders);

/// The methods of one folder, each against the first of its patch.
std::vector<Comparison> compare_methods(const ResultFolder& folder);

/// Table on the common lines first, own sets second, then the worst lines and warnings.
std::string to_markdown(const ComparisonReport& report);
std::string to_terminal(const ComparisonReport& report);  ///< the same in aligned columns

std::string to_json(const ComparisonReport& report);

}  // namespace ridgeline::evaluate
