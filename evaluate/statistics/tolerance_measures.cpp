// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/tolerance_measures.h"

#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/parameter_intervals.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr int kLimapSamples = 1000;

/// How much of a segment is near others: the share near those with a similar direction, and the
/// number of samples near any of them.
struct Nearness {
  double share = 0.0;
  int n_samples = 0;
};

Nearness nearness(const Segment3& segment,
                  std::span<const Segment3> others,
                  const std::vector<std::size_t>& candidates,
                  double tolerance_m,
                  double max_angle_rad) {
  std::vector<ParameterInterval> any;
  std::vector<ParameterInterval> along;
  const Eigen::Vector3d direction = segment.end - segment.start;
  for (const std::size_t i : candidates) {
    const std::optional<ParameterInterval> part = part_near(segment, others[i], tolerance_m);
    if (!part) continue;
    any.push_back(*part);
    const Eigen::Vector3d other_direction = others[i].end - others[i].start;
    if (acute_angle_rad(direction, other_direction) <= max_angle_rad) along.push_back(*part);
  }
  return {total_length(join(std::move(along))), count_samples(join(std::move(any)), kLimapSamples)};
}

/// Nearness of each segment to `others`, for each tolerance: result[tolerance][segment].
std::vector<std::vector<Nearness>> nearness_of_all(std::span<const Segment3> segments,
                                                   std::span<const Segment3> others,
                                                   const ToleranceOptions& options) {
  const std::vector<double>& tolerances_m = options.tolerances_m;
  std::vector<std::vector<Nearness>> result(tolerances_m.size(),
                                            std::vector<Nearness>(segments.size()));
  if (tolerances_m.empty()) return result;
  const double reach_m = *std::max_element(tolerances_m.begin(), tolerances_m.end());
  const double max_angle_rad = options.max_angle_deg * kRadPerDeg;
  const BoxIndex3 tree(others);
  tbb::parallel_for(std::size_t{0}, segments.size(), [&](std::size_t i) {
    const std::vector<std::size_t> candidates = tree.near(segments[i], reach_m);
    for (std::size_t k = 0; k < tolerances_m.size(); ++k) {
      result[k][i] = nearness(segments[i], others, candidates, tolerances_m[k], max_angle_rad);
    }
  });
  return result;
}

struct Lengths {
  double all_m = 0.0, near_m = 0.0, near_sampled_m = 0.0;
  std::size_t n_touched = 0;  ///< segments with a sample within tolerance
};

Lengths add_up(std::span<const double> lengths_m, const std::vector<Nearness>& nearness) {
  CompensatedSum all_m;
  CompensatedSum near_m;
  CompensatedSum sampled_m;
  Lengths result;
  for (std::size_t i = 0; i < lengths_m.size(); ++i) {
    all_m.add(lengths_m[i]);
    near_m.add(lengths_m[i] * nearness[i].share);
    sampled_m.add(lengths_m[i] * nearness[i].n_samples / kLimapSamples);
    if (nearness[i].n_samples > 0) ++result.n_touched;
  }
  result.all_m = all_m.value();
  result.near_m = near_m.value();
  result.near_sampled_m = sampled_m.value();
  return result;
}

std::optional<double> share_of(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

std::optional<double> f_score(std::optional<double> precision, std::optional<double> recall) {
  if (!precision || !recall) return std::nullopt;
  const double sum = *precision + *recall;
  return sum > 0.0 ? 2.0 * *precision * *recall / sum : 0.0;
}

std::optional<double> percent_touched(const Lengths& lines, std::size_t n_lines) {
  if (n_lines == 0) return std::nullopt;
  return 100.0 * static_cast<double>(lines.n_touched) / static_cast<double>(n_lines);
}

std::vector<double> lengths_of(std::span<const Segment3> segments, const char* what) {
  std::vector<double> lengths_m;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    check(all_finite(segments[i]), what, " ", i, ": coordinates must be finite");
    lengths_m.push_back(length(segments[i]));
  }
  return lengths_m;
}

void check_tolerances(const ToleranceOptions& options) {
  for (const double t : options.tolerances_m) {
    check(t > 0.0 && std::isfinite(t), "tolerance_m = ", t, ", must be > 0");
  }
}

/// How much of the line is within the tolerance of all its planes.
Nearness nearness_to_planes(const LineEvaluation& line, double tolerance_m) {
  ParameterInterval within{0.0, 1.0};
  double coverage = 1.0;
  for (const JudgingPlane& p : line.planes) {
    const std::optional<ParameterInterval> part =
        where_within(p.distance.start, p.distance.end, tolerance_m);
    if (!part) return {};
    within = {std::max(within.begin, part->begin), std::min(within.end, part->end)};
    coverage = std::min(coverage, p.coverage);
  }
  if (line.planes.empty() || within.begin > within.end) return {};
  return {coverage * (within.end - within.begin), count_samples({within}, kLimapSamples)};
}

}  // namespace

std::vector<double> tolerances_with_gsd(double gsd_m) {
  check(gsd_m > 0.0 && std::isfinite(gsd_m), "gsd_m = ", gsd_m, ", must be > 0");
  std::vector<double> tolerances_m = ToleranceOptions{}.tolerances_m;
  for (const double factor : {1.0, 2.0, 5.0}) tolerances_m.push_back(factor * gsd_m);
  std::sort(tolerances_m.begin(), tolerances_m.end());
  tolerances_m.erase(std::unique(tolerances_m.begin(), tolerances_m.end()), tolerances_m.end());
  return tolerances_m;
}

std::vector<ToleranceMeasures> measure_against_lines(std::span<const Segment3> lines,
                                                     std::span<const Segment3> references,
                                                     const ToleranceOptions& options) {
  check_tolerances(options);
  const std::vector<double> line_lengths_m = lengths_of(lines, "line");
  const std::vector<double> reference_lengths_m = lengths_of(references, "reference line");
  const auto line_nearness = nearness_of_all(lines, references, options);
  const auto reference_nearness = nearness_of_all(references, lines, options);
  std::vector<ToleranceMeasures> result;
  for (std::size_t k = 0; k < options.tolerances_m.size(); ++k) {
    const Lengths found = add_up(line_lengths_m, line_nearness[k]);
    const Lengths covered = add_up(reference_lengths_m, reference_nearness[k]);
    ToleranceMeasures m;
    m.tolerance_m = options.tolerances_m[k];
    m.precision = share_of(found.near_m, found.all_m);
    m.completeness = share_of(covered.near_m, covered.all_m);
    m.f_score = f_score(m.precision, m.completeness);
    m.redundancy = share_of(found.near_m, covered.near_m);
    m.limap_r_m = covered.near_sampled_m;
    m.limap_p_percent = percent_touched(found, lines.size());
    result.push_back(m);
  }
  return result;
}

std::vector<ToleranceMeasures> measure_against_planes(std::span<const LineEvaluation> lines,
                                                      const ToleranceOptions& options) {
  check_tolerances(options);
  std::vector<ToleranceMeasures> result;
  for (const double tolerance_m : options.tolerances_m) {
    std::vector<double> lengths_m;
    std::vector<Nearness> nearness;
    for (const LineEvaluation& line : lines) {
      if (line.status != Status::kEvaluated) continue;
      lengths_m.push_back(line.length_m);
      nearness.push_back(nearness_to_planes(line, tolerance_m));
    }
    const Lengths found = add_up(lengths_m, nearness);
    ToleranceMeasures m;
    m.tolerance_m = tolerance_m;
    m.precision = share_of(found.near_m, found.all_m);
    m.limap_r_m = found.near_sampled_m;
    m.limap_p_percent = percent_touched(found, lengths_m.size());
    result.push_back(m);
  }
  return result;
}

}  // namespace ridgeline::evaluate
