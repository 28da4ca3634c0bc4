// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/bootstrap.h"
#include "evaluate/statistics/decided_group.h"
#include "evaluate/statistics/interval.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

inline constexpr std::string_view kNotAligned = "not_aligned";
inline constexpr std::string_view kAligned = "aligned";
inline constexpr std::string_view kTotal = "total";

/// A line with e above this factor times the RMS is an outlier.
inline constexpr double kOutlierRmsFactor = 3.0;

struct SummaryOptions {
  BootstrapOptions bootstrap;
  double gross_m = 1.0;  ///< a line farther than this from its planes is a gross error
  std::optional<double>
      outlier_limit_m;       ///< limit of e for outliers, instead of kOutlierRmsFactor x RMS
  double sigma_sys_m = 0.0;  ///< systematic part of the LIDAR accuracy: datum, strip offset
};

/// Throws std::invalid_argument, naming the value, if a value is out of its range.
void validate(const SummaryOptions& options);

/// The figures of one cell: the lines of a class or stratum of one method on one patch.
/// e = mean |distance| of a line from its planes (Ok et al. 2011), v = its signed mean. A figure
/// that cannot be computed from the lines is empty, never 0.
struct Summary {
  std::string line_class;
  std::size_t n_lines = 0;                              ///< all input lines, regardless of status
  std::size_t n_evaluated = 0;                          ///< n of every figure below
  std::array<std::size_t, kNumStatuses> n_by_status{};  ///< indexed by Status
  double length_m = 0.0;                                ///< of all lines with a finite length
  double length_evaluated_m = 0.0;
  double sum_squares_m2 = 0.0;  ///< sum of e^2, which is additive over disjoint cells

  std::optional<double> rms_m;                   ///< sqrt(sum e^2 / n): the published quantity
  std::optional<Interval> ci95_m;                ///< of rms_m, clustered bootstrap
  std::optional<Interval> ci95_chi_square_m;     ///< of rms_m, if lines were independent
  std::size_t n_clusters = 0;                    ///< clusters that the bootstrap drew from
  std::optional<double> rms_length_weighted_m;   ///< sqrt(sum L e^2 / sum L)
  std::optional<double> mean_m;                  ///< of v: the bias
  std::optional<double> std_m;                   ///< of v, with n - 1; empty for n = 1
  std::optional<double> rms_signed_m;            ///< of v
  std::optional<double> median_m;                ///< of e
  std::optional<double> median_signed_m;         ///< of v
  std::optional<double> nmad_m;                  ///< of v
  std::optional<double> q683_m, q90_m, q95_m;    ///< of e, type 7
  std::optional<double> max_m;                   ///< of e
  std::string max_id;                            ///< the line of max_m
  std::optional<double> gross_share;             ///< lines with e > gross_m
  std::size_t n_outliers = 0;                    ///< never excluded from the figures above
  std::optional<double> rms_without_outliers_m;  ///< rms_m of the lines that are not outliers
  /// The number of lines, those farthest off, that account for half of sum_squares_m2, and rms_m of
  /// the others. A few lines can dominate the RMS.
  std::size_t n_half_of_squares = 0;
  std::optional<double> rms_without_half_m;

  std::size_t n_parts = 0;                  ///< ridges and hips with a RidgeDisplacement
  std::optional<double> rmse_horizontal_m;  ///< of the n_parts lines, across the line in plan
  std::optional<double> rmse_vertical_m;    ///< of the n_parts lines, in height
  std::optional<double> mean_vertical_m;    ///< of the n_parts lines; positive if they are too high

  /// If points or place decided the surface of some lines of the class: its figures for each of
  /// kDecidedGroups, over all lines of the class, of which only those of the group count as
  /// evaluated. Otherwise empty.
  std::vector<Summary> by_group;
  /// The figures of a group; without evaluated lines if the class has no lines of the group.
  [[nodiscard]] Summary of_group(DecidedGroup group) const;

  [[nodiscard]] bool few_clusters() const { return n_clusters < kMinClusters; }
  /// n_evaluated / n_lines, printed with every RMS; empty for no lines.
  [[nodiscard]] std::optional<double> evaluated_share() const;
  [[nodiscard]] std::optional<double> evaluated_share_by_length() const;
};

/// The figures of the lines whose index is in `members`; `clusters[i]` is the label of line i. If a
/// group is given, the evaluated lines of the other group are included in the number of lines only.
/// Throws std::invalid_argument if the spans `lines` and `clusters` differ in length, and
/// std::logic_error if an evaluated line has a distance that is not finite.
Summary summarize(std::span<const LineEvaluation> lines,
                  std::span<const std::size_t> clusters,
                  std::span<const std::size_t> members,
                  std::string line_class,
                  const SummaryOptions& options,
                  std::optional<DecidedGroup> group = {});

/// `not_aligned`, `aligned` and `total`, in this order; only `total` if there are lines but none in
/// the first two classes. Lines of any other class are included in `total` only. The pooled
/// identity is asserted for the classes and for the groups of each.
std::vector<Summary> summarize_classes(std::span<const LineEvaluation> lines,
                                       const SummaryOptions& options);

/// The summary of a class, or nullptr.
const Summary* find_class(std::span<const Summary> summaries, std::string_view line_class);

/// Checks the pooled identity of disjoint parts: their numbers of lines, of evaluated lines and of
/// each status, and their sums of squares, must add up to those of the total (relative 1e-12), and
/// the total's statuses to its number of lines. Otherwise throws std::logic_error naming the cell
/// and the two numbers, which indicates a defect of this program.
void assert_pooled(const Summary& total, std::span<const Summary> parts);

/// The same check for the evaluated lines and squares of Summary::by_group, if there are any.
void assert_groups_pooled(const Summary& total);

}  // namespace ridgeline::evaluate
