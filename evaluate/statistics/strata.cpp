// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/strata.h"

#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/image_count.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace ridgeline::evaluate {
namespace {

/// Index of a line's bin; empty if the line lacks the property.
using BinOf = std::function<std::optional<std::size_t>(const LineEvaluation&)>;

struct LineProperty {
  std::string name;
  std::vector<std::string> labels;  ///< of the bins
  BinOf bin_of;
};

/// Index of the bin (bounds[k], bounds[k + 1]] that contains the value. The first bin includes its
/// lower bound. Empty for a value outside all bins.
std::optional<std::size_t> bin_index(const std::vector<double>& bounds, double value) {
  if (!(value >= bounds.front() && value <= bounds.back())) return std::nullopt;
  const auto upper = std::lower_bound(bounds.begin() + 1, bounds.end(), value);
  return static_cast<std::size_t>(upper - bounds.begin()) - 1;
}

std::vector<std::string> bin_labels(const std::vector<double>& bounds) {
  std::vector<std::string> labels;
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k) {
    labels.push_back(bounds[k + 1] == std::numeric_limits<double>::infinity()
                         ? fmt::format("> {}", bounds[k])
                         : fmt::format("{}-{}", bounds[k], bounds[k + 1]));
  }
  return labels;
}

LineProperty by_number(
    std::string name,
    const std::vector<double>& bounds,
    const std::function<std::optional<double>(const LineEvaluation&)>& value_of) {
  return {std::move(name), bin_labels(bounds),
          [bounds, value_of](const LineEvaluation& line) -> std::optional<std::size_t> {
            const std::optional<double> value = value_of(line);
            return value ? bin_index(bounds, *value) : std::nullopt;
          }};
}

LineProperty by_kind() {
  return {"kind", {"step", "ridge"}, [](const LineEvaluation& line) -> std::optional<std::size_t> {
            if (line.kind == Kind::kNone) return std::nullopt;
            return line.kind == Kind::kStep ? 0 : 1;
          }};
}

std::optional<double> steepest_slope_deg(const LineEvaluation& line) {
  std::optional<double> steepest;
  for (const JudgingPlane& p : line.planes) {
    const double slope_deg = deg_from_rad(slope_rad(p.plane));
    steepest = std::max(steepest.value_or(0.0), slope_deg);
  }
  return steepest;
}

/// The lines by the quartiles of their predicted sigma, computed from the lines of this evaluation.
LineProperty by_sigma(const Evaluation& evaluation) {
  std::vector<double> sigmas_m;
  for (const LineEvaluation& line : evaluation.lines) {
    if (line.sigma_line_m) sigmas_m.push_back(*line.sigma_line_m);
  }
  std::vector<double> bounds{0.0};
  for (const double share : {0.25, 0.5, 0.75}) {
    bounds.push_back(quantile(sigmas_m, share).value_or(0.0));
  }
  bounds.push_back(std::numeric_limits<double>::infinity());
  LineProperty property = by_number("sigma_line_quartile", bounds,
                                    [](const LineEvaluation& line) { return line.sigma_line_m; });
  property.labels = {"1", "2", "3", "4"};
  return property;
}

LineProperty by_images() {
  std::vector<std::string> labels;
  for (std::size_t group = 0; group < kNumImageGroups; ++group)
    labels.push_back(image_group_name(group));
  return {"n_images", labels,
          [](const LineEvaluation& line) { return image_group(line.n_images); }};
}

LineProperty by_decision() {
  return {"decided_by",
          transformed(kDecidedGroups, [](DecidedGroup group) { return std::string(name(group)); }),
          [](const LineEvaluation& line) -> std::optional<std::size_t> {
            if (line.status != Status::kEvaluated) return std::nullopt;
            return static_cast<std::size_t>(decided_group(line));
          }};
}

bool is_of_place(const LineEvaluation& line) {
  return decided_group(line) == DecidedGroup::kPointsPlace;
}

bool is_of_many_images(const LineEvaluation& line) { return line.n_images.value_or(0) > 2; }

std::vector<LineProperty> properties(const Evaluation& evaluation) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<LineProperty> result{
      by_number("epipolar_angle_deg", {0.0, 2.0, 5.0, 10.0, 20.0, 45.0, 90.0},
                [](const LineEvaluation& line) { return line.epipolar_angle_deg; }),
      by_kind(),
      by_number("length_m", {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, kInfinity},
                [](const LineEvaluation& line) { return std::optional(line.length_m); }),
      by_number("roof_slope_deg", {0.0, 5.0, 20.0, 35.0, 50.0, 90.0}, steepest_slope_deg),
      by_sigma(evaluation)};
  if (std::ranges::any_of(evaluation.lines, is_of_many_images)) result.push_back(by_images());
  if (std::ranges::any_of(evaluation.lines, is_of_place)) result.push_back(by_decision());
  return result;
}

Stratification stratify_by(const LineProperty& property,
                           const Evaluation& evaluation,
                           const std::vector<std::size_t>& clusters,
                           const Summary& total) {
  std::vector<std::string> labels = property.labels;
  labels.emplace_back("unknown");
  std::vector<std::vector<std::size_t>> members(labels.size());
  for (std::size_t i = 0; i < evaluation.lines.size(); ++i) {
    members[property.bin_of(evaluation.lines[i]).value_or(labels.size() - 1)].push_back(i);
  }
  Stratification result{property.name, {}};
  std::vector<Summary> parts;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    parts.push_back(
        summarize(evaluation.lines, clusters, members[k], labels[k], evaluation.options));
    const bool unused = k + 1 == labels.size() && members[k].empty();
    if (unused) continue;
    result.strata.push_back({parts.back(), calibrate(evaluation.lines, members[k], labels[k],
                                                     evaluation.options.sigma_sys_m)});
  }
  assert_pooled(total, parts);
  return result;
}

}  // namespace

std::vector<Stratification> stratify(const Evaluation& evaluation) {
  const std::vector<std::size_t> clusters = cluster_labels(evaluation.lines);
  std::vector<std::size_t> all(evaluation.lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Summary total =
      summarize(evaluation.lines, clusters, all, std::string(kTotal), evaluation.options);
  return transformed(properties(evaluation), [&](const LineProperty& property) {
    return stratify_by(property, evaluation, clusters, total);
  });
}

}  // namespace ridgeline::evaluate
