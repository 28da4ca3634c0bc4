// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/standards.h"

#include "evaluate/statistics/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ridgeline::evaluate {
namespace {

std::vector<const LineEvaluation*> evaluated_of(const Evaluation& evaluation,
                                                const std::string& line_class) {
  std::vector<const LineEvaluation*> lines;
  for (const LineEvaluation& line : evaluation.lines) {
    const bool counts = line_class == kTotal || line.line_class == line_class;
    if (counts && line.status == Status::kEvaluated) lines.push_back(&line);
  }
  return lines;
}

template <typename Square>
double root_mean(const std::vector<const LineEvaluation*>& lines, const Square& square) {
  if (lines.empty()) return 0.0;
  CompensatedSum sum;
  for (const LineEvaluation* line : lines) sum.add(square(*line));
  return std::sqrt(sum.value() / static_cast<double>(lines.size()));
}

/// Variance of the mean distance from a line's planes due to the points' independent errors.
double random_variance_m2(const LineEvaluation& line) {
  const auto n = static_cast<double>(line.planes.size());
  double variance_m2 = 0.0;
  for (const JudgingPlane& p : line.planes) variance_m2 += std::pow(p.sigma_random_m / n, 2);
  return variance_m2;
}

UncertaintyBudget budget_of(const std::vector<const LineEvaluation*>& lines,
                            const Summary& summary,
                            double sigma_sys_m) {
  constexpr double kTwoSided95 = 2.0 * 1.959964;
  UncertaintyBudget budget;
  budget.laser_random_m = root_mean(lines, random_variance_m2);
  budget.laser_systematic_m = sigma_sys_m;
  budget.plane_fit_m = root_mean(lines, [](const LineEvaluation& line) {
    return std::max(0.0, *line.sigma_plane_m * *line.sigma_plane_m - random_variance_m2(line));
  });
  if (summary.ci95_m) {
    budget.sampling_m = (summary.ci95_m->high - summary.ci95_m->low) / kTwoSided95;
  }
  return budget;
}

AsprsFigures asprs_of(const std::vector<const LineEvaluation*>& lines,
                      const Summary& summary,
                      const UncertaintyBudget& budget) {
  constexpr std::size_t kCheckpoints = 30;
  constexpr double kBiasShare = 0.25;
  constexpr double kTwiceAsAccurate = 2.0;
  AsprsFigures figures;
  figures.n = summary.n_parts;
  figures.best_class_m = kTwiceAsAccurate * budget.combined_m();
  figures.few_checkpoints = summary.n_parts < kCheckpoints;
  if (summary.n_parts == 0) return figures;
  std::vector<const LineEvaluation*> ridges;
  std::ranges::copy_if(lines, std::back_inserter(ridges),
                       [](const LineEvaluation* line) { return line->displacement.has_value(); });
  const auto with_reference = [&](double observed_m, int part) {
    const double reference_m = root_mean(ridges, [part](const LineEvaluation& line) {
      return line.displacement->covariance_m2(part, part);
    });
    return std::hypot(observed_m, reference_m, budget.laser_systematic_m);
  };
  figures.rmse_horizontal_m = with_reference(*summary.rmse_horizontal_m, 0);
  figures.rmse_vertical_m = with_reference(*summary.rmse_vertical_m, 1);
  figures.rmse_3d_m = std::hypot(*figures.rmse_horizontal_m, *figures.rmse_vertical_m);
  figures.biased = std::abs(*summary.mean_vertical_m) > kBiasShare * *summary.rmse_vertical_m;
  return figures;
}

NssdaFigures nssda_of(const AsprsFigures& asprs) {
  constexpr std::size_t kMinSampleSize = 20;
  constexpr double kHorizontal = 1.7308, kVertical = 1.9600;
  if (asprs.n < kMinSampleSize) return {};
  return {kHorizontal * *asprs.rmse_horizontal_m, kVertical * *asprs.rmse_vertical_m};
}

std::optional<double> mean_value_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return sum(values) / static_cast<double>(values.size());
}

std::vector<IsoMeasure> measures_of(const std::vector<const LineEvaluation*>& lines,
                                    const Summary& s,
                                    const SummaryOptions& options) {
  std::vector<double> errors_m;
  errors_m.reserve(lines.size());
  for (const LineEvaluation* line : lines) errors_m.push_back(*line->mean_distance_m);
  std::vector<double> kept_m = errors_m;
  const double limit_m =
      options.outlier_limit_m.value_or(kOutlierRmsFactor * s.rms_m.value_or(0.0));
  std::erase_if(kept_m, [&](double e) { return e > limit_m; });
  const auto n_gross = static_cast<double>(
      std::ranges::count_if(errors_m, [&](double e) { return e > options.gross_m; }));
  const std::size_t n = s.n_evaluated;
  return {{28, "mean value of positional uncertainties", mean_value_of(errors_m), "m", n},
          {29, "the same without outliers", mean_value_of(kept_m), "m", kept_m.size()},
          {30, "number of positional uncertainties above the gross limit", n_gross, "count", n},
          {31, "rate of positional uncertainties above the gross limit", s.gross_share, "1", n},
          {33, "LE50: half of the distances are not larger", s.median_m, "m", n},
          {34, "LE68.3", s.q683_m, "m", n},
          {35, "LE90", s.q90_m, "m", n},
          {36, "LE95", s.q95_m, "m", n},
          {39, "root mean square error", s.rms_m, "m", n},
          {47, "root mean square error of planimetry (ridges and hips, across)",
           s.rmse_horizontal_m, "m", s.n_parts},
          {128, "bias of positions (signed distances)", s.mean_m, "m", n}};
}

void add_completeness(const ToleranceMeasures& m,
                      std::size_t n,
                      std::vector<IsoMeasure>& measures) {
  const auto rest = [](std::optional<double> share) {
    return share ? std::optional(1.0 - *share) : std::nullopt;
  };
  const std::string how =
      fmt::format(", by length, within {:g} m of a reference line", m.tolerance_m);
  measures.push_back({7, "rate of missing items" + how, rest(m.completeness), "1", n});
  measures.push_back({3, "rate of excess items" + how, rest(m.precision), "1", n});
}

}  // namespace

double UncertaintyBudget::combined_m() const {
  return std::hypot(laser_random_m, laser_systematic_m, plane_fit_m);
}

std::vector<StandardsBlock> standards_blocks(
    const Evaluation& evaluation, const std::optional<ToleranceMeasures>& against_lines) {
  std::vector<StandardsBlock> blocks;
  for (const Summary& summary : evaluation.classes) {
    const auto lines = evaluated_of(evaluation, summary.line_class);
    StandardsBlock block;
    block.line_class = summary.line_class;
    block.budget = budget_of(lines, summary, evaluation.options.sigma_sys_m);
    block.asprs = asprs_of(lines, summary, block.budget);
    block.nssda = nssda_of(block.asprs);
    block.iso19157 = measures_of(lines, summary, evaluation.options);
    if (against_lines && summary.line_class == kTotal) {
      add_completeness(*against_lines, summary.n_lines, block.iso19157);
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace ridgeline::evaluate
