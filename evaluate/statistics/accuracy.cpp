// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/accuracy.h"

#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

bool counts_in(const LineEvaluation& line, const std::string& line_class) {
  return line.status == Status::kEvaluated &&
         (line_class == kTotal || line.line_class == line_class);
}

double max_extrapolation_m(const LineEvaluation& line) {
  double largest_m = 0.0;
  for (const JudgingPlane& p : line.planes) largest_m = std::max(largest_m, p.extrapolation_m);
  return largest_m;
}

bool is_biased(const Summary& summary) {
  constexpr double kBiasShare = 0.25;
  return summary.mean_m && std::abs(*summary.mean_m) > kBiasShare * *summary.rms_signed_m;
}

AccuracyStatement statement(const Evaluation& evaluation, const Summary& summary) {
  constexpr std::size_t kMinSamples = 30;
  constexpr double kExtrapolationLimitM = 0.5;
  constexpr double kExtrapolatedShareLimit = 0.05;
  CompensatedSum variance_m2;
  std::size_t n_extrapolated = 0;
  for (const LineEvaluation& line : evaluation.lines) {
    if (!counts_in(line, summary.line_class)) continue;
    variance_m2.add(*line.sigma_plane_m * *line.sigma_plane_m);
    if (max_extrapolation_m(line) > kExtrapolationLimitM) ++n_extrapolated;
  }
  AccuracyStatement result;
  result.line_class = summary.line_class;
  result.n = summary.n_evaluated;
  const double n = std::max(1.0, static_cast<double>(summary.n_evaluated));
  result.numbers = accuracy_numbers(summary.rms_m, std::hypot(evaluation.options.sigma_sys_m,
                                                              std::sqrt(variance_m2.value() / n)));
  result.n_half_of_squares = summary.n_half_of_squares;
  result.rms_without_half_m = summary.rms_without_half_m;
  result.biased = is_biased(summary);
  result.few_samples = summary.n_evaluated < kMinSamples;
  result.few_clusters = summary.few_clusters();
  result.extrapolated_share = static_cast<double>(n_extrapolated) / n;
  result.extrapolated = result.extrapolated_share > kExtrapolatedShareLimit;
  return result;
}

}  // namespace

AccuracyNumbers accuracy_numbers(std::optional<double> observed_m, double sigma_ref_m) {
  check(!observed_m || *observed_m >= 0.0, "observed_m = ", observed_m.value_or(0.0),
        ", must be >= 0");
  check(sigma_ref_m >= 0.0, "sigma_ref_m = ", sigma_ref_m, ", must be >= 0");
  AccuracyNumbers numbers;
  numbers.observed_m = observed_m;
  numbers.sigma_ref_m = sigma_ref_m;
  if (!observed_m) return numbers;
  numbers.product_m = std::hypot(*observed_m, sigma_ref_m);
  numbers.below_reference_noise = *observed_m < sigma_ref_m;
  if (!numbers.below_reference_noise) {
    numbers.method_only_m = std::sqrt((*observed_m - sigma_ref_m) * (*observed_m + sigma_ref_m));
  }
  return numbers;
}

std::vector<std::string> AccuracyStatement::flags() const {
  std::vector<std::string> names;
  if (biased) names.emplace_back("bias");
  if (few_samples) names.emplace_back("n_below_30");
  if (few_clusters) names.emplace_back("few_clusters");
  if (extrapolated) names.emplace_back("extrapolation");
  if (numbers.below_reference_noise) names.emplace_back("below_reference_noise");
  return names;
}

std::vector<AccuracyStatement> accuracy_statements(const Evaluation& evaluation) {
  return transformed(evaluation.classes,
                     [&](const Summary& s) { return statement(evaluation, s); });
}

}  // namespace ridgeline::evaluate
