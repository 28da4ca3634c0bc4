// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/summary.h"

#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

/// The figures of the evaluated members, as columns of equal length.
struct EvaluatedSample {
  std::vector<double> errors, signed_errors, lengths;
  std::vector<std::size_t> clusters;
  std::vector<std::string> ids;
};

bool counts(const LineEvaluation& line, std::optional<DecidedGroup> group) {
  return line.status == Status::kEvaluated && (!group || decided_group(line) == *group);
}

EvaluatedSample evaluated_sample(std::span<const LineEvaluation> lines,
                                 std::span<const std::size_t> clusters,
                                 std::span<const std::size_t> members,
                                 std::optional<DecidedGroup> group) {
  EvaluatedSample sample;
  for (const std::size_t i : members) {
    const LineEvaluation& line = lines[i];
    if (!counts(line, group)) continue;
    const auto is_finite = [](std::optional<double> x) { return x && std::isfinite(*x); };
    if (!is_finite(line.mean_distance_m) || !is_finite(line.signed_mean_m)) {
      throw std::logic_error("line " + line.id + " is evaluated, but its distance is not finite");
    }
    sample.errors.push_back(*line.mean_distance_m);
    sample.signed_errors.push_back(*line.signed_mean_m);
    sample.lengths.push_back(line.length_m);
    sample.clusters.push_back(clusters[i]);
    sample.ids.push_back(line.id);
  }
  return sample;
}

void count(std::span<const LineEvaluation> lines,
           std::span<const std::size_t> members,
           std::optional<DecidedGroup> group,
           Summary& summary) {
  CompensatedSum length_m;
  CompensatedSum length_evaluated_m;
  for (const std::size_t i : members) {
    const LineEvaluation& line = lines[i];
    ++summary.n_lines;
    ++summary.n_by_status.at(static_cast<std::size_t>(line.status));
    if (!std::isfinite(line.length_m)) continue;
    length_m.add(line.length_m);
    if (counts(line, group)) length_evaluated_m.add(line.length_m);
  }
  summary.length_m = length_m.value();
  summary.length_evaluated_m = length_evaluated_m.value();
}

double root_mean_square(std::span<const double> values) {
  return std::sqrt(sum_of_squares(values) / static_cast<double>(values.size()));
}

void describe_signed(const std::vector<double>& values, Summary& summary) {
  const auto n = static_cast<double>(values.size());
  const double mean = sum(values) / n;
  summary.mean_m = mean;
  summary.rms_signed_m = root_mean_square(values);
  summary.median_signed_m = median(values);
  summary.nmad_m = nmad(values);
  if (values.size() < 2) return;
  CompensatedSum squares;
  for (const double v : values) squares.add((v - mean) * (v - mean));
  summary.std_m = std::sqrt(squares.value() / (n - 1.0));
}

std::optional<double> length_weighted_rms(const EvaluatedSample& sample) {
  CompensatedSum squares;
  CompensatedSum weights;
  for (std::size_t i = 0; i < sample.errors.size(); ++i) {
    squares.add(sample.lengths[i] * sample.errors[i] * sample.errors[i]);
    weights.add(sample.lengths[i]);
  }
  if (!(weights.value() > 0.0)) return std::nullopt;
  return std::sqrt(squares.value() / weights.value());
}

/// Outliers are rejected only once: an iterated 3 RMS rule would keep removing values from heavy
/// tails.
void describe_outliers(const std::vector<double>& errors,
                       const SummaryOptions& options,
                       Summary& summary) {
  const double limit = options.outlier_limit_m.value_or(kOutlierRmsFactor * *summary.rms_m);
  std::vector<double> kept = errors;
  std::erase_if(kept, [&](double e) { return e > limit; });
  summary.n_outliers = errors.size() - kept.size();
  if (!kept.empty()) summary.rms_without_outliers_m = root_mean_square(kept);
}

void describe_half_of_squares(std::vector<double> errors, Summary& summary) {
  std::sort(errors.begin(), errors.end(), std::greater());
  double squares_m2 = 0.0;
  auto other = errors.begin();
  for (; other != errors.end() && squares_m2 < 0.5 * summary.sum_squares_m2; ++other) {
    squares_m2 += *other * *other;
  }
  summary.n_half_of_squares = static_cast<std::size_t>(other - errors.begin());
  if (other != errors.end()) summary.rms_without_half_m = root_mean_square({other, errors.end()});
}

void describe_errors(const EvaluatedSample& sample,
                     const SummaryOptions& options,
                     Summary& summary) {
  const std::vector<double>& errors = sample.errors;
  const auto n = static_cast<double>(errors.size());
  summary.rms_m = std::sqrt(summary.sum_squares_m2 / n);
  summary.ci95_m = bootstrap_rms(errors, sample.clusters, options.bootstrap);
  summary.ci95_chi_square_m =
      chi_square_rms_interval(*summary.rms_m, errors.size(), options.bootstrap.level);
  summary.rms_length_weighted_m = length_weighted_rms(sample);
  summary.median_m = median(errors);
  summary.q683_m = quantile(errors, 0.683);
  summary.q90_m = quantile(errors, 0.90);
  summary.q95_m = quantile(errors, 0.95);
  const auto largest = std::max_element(errors.begin(), errors.end());
  summary.max_m = *largest;
  summary.max_id = sample.ids[static_cast<std::size_t>(largest - errors.begin())];
  const auto n_gross =
      std::count_if(errors.begin(), errors.end(), [&](double e) { return e > options.gross_m; });
  summary.gross_share = static_cast<double>(n_gross) / n;
  describe_outliers(errors, options, summary);
  describe_half_of_squares(errors, summary);
}

void describe_parts(std::span<const LineEvaluation> lines,
                    std::span<const std::size_t> members,
                    std::optional<DecidedGroup> group,
                    Summary& summary) {
  std::vector<double> horizontal_m;
  std::vector<double> vertical_m;
  for (const std::size_t i : members) {
    if (!lines[i].displacement || !counts(lines[i], group)) continue;
    horizontal_m.push_back(lines[i].displacement->horizontal_m);
    vertical_m.push_back(lines[i].displacement->vertical_m);
  }
  summary.n_parts = horizontal_m.size();
  if (horizontal_m.empty()) return;
  summary.rmse_horizontal_m = root_mean_square(horizontal_m);
  summary.rmse_vertical_m = root_mean_square(vertical_m);
  summary.mean_vertical_m = sum(vertical_m) / static_cast<double>(vertical_m.size());
}

void expect_equal(const Summary& total, const char* what, double whole, double parts) {
  constexpr double kRelativeTolerance = 1e-12;  // rounding of the compensated sums is near 1e-15
  if (std::abs(whole - parts) <= kRelativeTolerance * std::max(std::abs(whole), std::abs(parts))) {
    return;
  }
  std::ostringstream message;
  message.precision(17);
  message << "pooled identity of " << total.line_class << " violated: " << what << " = " << whole
          << ", but its parts add up to " << parts;
  throw std::logic_error(message.str());
}

std::vector<std::size_t> members_of(std::span<const LineEvaluation> lines,
                                    std::string_view line_class) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].line_class == line_class) members.push_back(i);
  }
  return members;
}

std::vector<std::size_t> members_of_no_class(std::span<const LineEvaluation> lines) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& c = lines[i].line_class;
    if (c != kNotAligned && c != kAligned) members.push_back(i);
  }
  return members;
}

/// The summary with its groups. If no line was decided by points or place, there are none, because
/// one group would repeat the summary.
Summary with_groups(Summary summary, const std::function<Summary(DecidedGroup)>& summary_of) {
  Summary of_place = summary_of(DecidedGroup::kPointsPlace);
  if (of_place.n_evaluated == 0) return summary;
  summary.by_group = {summary_of(DecidedGroup::kPlanImages), std::move(of_place)};
  assert_groups_pooled(summary);
  return summary;
}

}  // namespace

Summary Summary::of_group(DecidedGroup group) const {
  if (!by_group.empty()) return by_group[static_cast<std::size_t>(group)];
  if (group == DecidedGroup::kPlanImages) return *this;
  Summary none;
  none.line_class = line_class;
  none.n_lines = n_lines;
  none.n_by_status = n_by_status;
  none.length_m = length_m;
  return none;
}

void validate(const SummaryOptions& options) {
  check(std::isfinite(options.gross_m) && options.gross_m > 0.0, "`gross_m` = ", options.gross_m,
        ", must be finite and > 0");
  check(std::isfinite(options.sigma_sys_m) && options.sigma_sys_m >= 0.0,
        "`sigma_sys_m` = ", options.sigma_sys_m, ", must be finite and >= 0");
}

std::optional<double> Summary::evaluated_share() const {
  if (n_lines == 0) return std::nullopt;
  return static_cast<double>(n_evaluated) / static_cast<double>(n_lines);
}

std::optional<double> Summary::evaluated_share_by_length() const {
  if (!(length_m > 0.0)) return std::nullopt;
  return length_evaluated_m / length_m;
}

Summary summarize(std::span<const LineEvaluation> lines,
                  std::span<const std::size_t> clusters,
                  std::span<const std::size_t> members,
                  std::string line_class,
                  const SummaryOptions& options,
                  std::optional<DecidedGroup> group) {
  check(lines.size() == clusters.size(), "summarize: ", lines.size(), " lines, but ",
        clusters.size(), " cluster labels");
  Summary summary;
  summary.line_class = std::move(line_class);
  count(lines, members, group, summary);
  const EvaluatedSample sample = evaluated_sample(lines, clusters, members, group);
  summary.n_evaluated = sample.errors.size();
  summary.sum_squares_m2 = sum_of_squares(sample.errors);
  summary.n_clusters = count_clusters(sample.clusters);
  if (summary.n_evaluated == 0) return summary;
  describe_errors(sample, options, summary);
  describe_signed(sample.signed_errors, summary);
  describe_parts(lines, members, group, summary);
  return summary;
}

std::vector<Summary> summarize_classes(std::span<const LineEvaluation> lines,
                                       const SummaryOptions& options) {
  const std::vector<std::size_t> clusters = cluster_labels(lines);
  const auto summary_of = [&](const std::vector<std::size_t>& members, std::string_view name) {
    const auto of_group = [&](std::optional<DecidedGroup> group) {
      return summarize(lines, clusters, members, std::string(name), options, group);
    };
    return with_groups(of_group({}), of_group);
  };
  std::vector<std::size_t> all(lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> no_class = members_of_no_class(lines);

  std::vector<Summary> result{summary_of(members_of(lines, kNotAligned), kNotAligned),
                              summary_of(members_of(lines, kAligned), kAligned)};
  Summary total = summary_of(all, kTotal);
  assert_pooled(total, std::vector{result[0], result[1], summary_of(no_class, "no class")});
  if (!lines.empty() && no_class.size() == lines.size()) result.clear();
  result.push_back(std::move(total));
  return result;
}

const Summary* find_class(std::span<const Summary> summaries, std::string_view line_class) {
  const auto found = std::find_if(summaries.begin(), summaries.end(),
                                  [&](const Summary& s) { return s.line_class == line_class; });
  return found == summaries.end() ? nullptr : &*found;
}

void assert_groups_pooled(const Summary& total) {
  if (total.by_group.empty()) return;
  double n_evaluated = 0.0, sum_squares_m2 = 0.0;
  for (const Summary& group : total.by_group) {
    n_evaluated += static_cast<double>(group.n_evaluated);
    sum_squares_m2 += group.sum_squares_m2;
  }
  expect_equal(total, "n_evaluated of the groups", static_cast<double>(total.n_evaluated),
               n_evaluated);
  expect_equal(total, "sum of squares of the groups", total.sum_squares_m2, sum_squares_m2);
}

void assert_pooled(const Summary& total, std::span<const Summary> parts) {
  std::array<std::size_t, kNumStatuses> n_by_status{};
  std::size_t n_lines = 0;
  std::size_t n_evaluated = 0;
  CompensatedSum sum_squares_m2;
  for (const Summary& part : parts) {
    n_lines += part.n_lines;
    n_evaluated += part.n_evaluated;
    sum_squares_m2.add(part.sum_squares_m2);
    for (std::size_t s = 0; s < n_by_status.size(); ++s) n_by_status[s] += part.n_by_status[s];
  }
  const auto number = [](std::size_t n) { return static_cast<double>(n); };
  expect_equal(total, "n_lines", number(total.n_lines), number(n_lines));
  expect_equal(total, "n_evaluated", number(total.n_evaluated), number(n_evaluated));
  expect_equal(total, "sum of squares", total.sum_squares_m2, sum_squares_m2.value());
  for (std::size_t s = 0; s < n_by_status.size(); ++s) {
    expect_equal(total, name(static_cast<Status>(s)), number(total.n_by_status[s]),
                 number(n_by_status[s]));
  }
  const std::size_t n_statuses =
      std::accumulate(total.n_by_status.begin(), total.n_by_status.end(), std::size_t{0});
  expect_equal(total, "n_lines against the statuses", number(total.n_lines), number(n_statuses));
}

}  // namespace ridgeline::evaluate
