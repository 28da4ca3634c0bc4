// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/reference_errors.h"

#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/parameter_intervals.h"
#include "evaluate/statistics/summary.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ridgeline::evaluate {
namespace {

/// Larger distance of the ends of `segment` from the image of the reference line, extended by the
/// same distance beyond its ends; infinite where they are not beside it.
double distance_in_image(const ProjectionMatrix& image_from_local,
                         const Segment2& segment_px,
                         const Segment3& reference,
                         double margin_px) {
  const Segment2 seen = project(image_from_local, reference);
  const double length_px = length(seen);
  if (!(length_px > 0.0)) return HUGE_VAL;
  const Eigen::Vector2d along = (seen.end - seen.start) / length_px;
  double largest = 0.0;
  for (const Eigen::Vector2d& end : {segment_px.start, segment_px.end}) {
    const Eigen::Vector2d offset = end - seen.start;
    const double s = offset.dot(along);
    if (s < -margin_px || s > length_px + margin_px) return HUGE_VAL;
    largest = std::max(largest, std::abs(offset.x() * along.y() - offset.y() * along.x()));
  }
  return largest;
}

std::optional<std::size_t> reference_of(const JudgedLine& line,
                                        std::span<const ReferenceLine> references,
                                        const ReferenceOptions& options) {
  constexpr double kBeyondEnds_px = 5.0;  // an extracted end may run on along a neighbour's edge
  if (!line.images) return std::nullopt;
  std::optional<std::size_t> best;
  double nearest_px = options.max_distance_px;
  for (std::size_t r = 0; r < references.size(); ++r) {
    double worse_px = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      worse_px = std::max(
          worse_px, distance_in_image(line.images->image_from_local[i], line.images->segments_px[i],
                                      references[r].segment, kBeyondEnds_px));
    }
    if (worse_px > nearest_px) continue;
    nearest_px = worse_px;
    best = r;
  }
  return best;
}

/// Mean distance of the segment from the infinite line; its distance function is convex, so that a
/// few samples are exact to a per cent where it is not linear.
double mean_distance_m(const Segment3& segment, const Segment3& reference) {
  constexpr int kSamples = 11;
  const Eigen::ParametrizedLine<double, 3> line =
      Eigen::ParametrizedLine<double, 3>::Through(reference.start, reference.end);
  double sum_m = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    sum_m += line.distance(point_at(segment, static_cast<double>(i) / (kSamples - 1)));
  }
  return sum_m / kSamples;
}

bool has_geometry(const JudgedLine& line) { return line.reconstructed && all_finite(line.segment); }

bool is_of(const JudgedLine& line, std::string_view line_class) {
  return line_class == kTotal || line.line_class == line_class;
}

ReferenceErrors errors_of(std::span<const JudgedLine> lines,
                          std::span<const std::optional<double>> errors_m,
                          std::string_view line_class,
                          const ReferenceOptions& options) {
  ReferenceErrors result;
  result.line_class = line_class;
  std::vector<double> e;
  std::size_t gross = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_of(lines[i], line_class)) continue;
    ++result.n_lines;
    if (!errors_m[i]) continue;
    e.push_back(*errors_m[i]);
    if (*errors_m[i] > options.gross_m) ++gross;
  }
  result.n_on_reference = e.size();
  if (e.empty()) return result;
  const auto n = static_cast<double>(e.size());
  result.rms_m = std::sqrt(sum_of_squares(e) / n);
  result.median_m = median(e);
  result.q95_m = quantile(e, 0.95);
  result.max_m = *std::max_element(e.begin(), e.end());
  result.gross_share = static_cast<double>(gross) / n;
  return result;
}

bool is_reconstructed(const Segment3& reference,
                      std::span<const JudgedLine> lines,
                      const ReferenceOptions& options) {
  const Eigen::Vector3d direction = reference.end - reference.start;
  std::vector<ParameterInterval> covered;
  for (const JudgedLine& line : lines) {
    if (!has_geometry(line)) continue;
    const Eigen::Vector3d other = line.segment.end - line.segment.start;
    if (acute_angle_rad(direction, other) > options.max_angle_deg * std::numbers::pi / 180.0) {
      continue;
    }
    const auto part = part_near(reference, line.segment, options.tolerance_m);
    if (part) covered.push_back(*part);
  }
  return total_length(join(std::move(covered))) >= options.min_covered;
}

std::vector<ReferenceCompleteness> completeness_of(std::span<const JudgedLine> lines,
                                                   std::span<const ReferenceLine> references,
                                                   const ReferenceOptions& options) {
  std::vector<char> found(references.size(), 0);
  tbb::parallel_for(std::size_t{0}, references.size(), [&](std::size_t r) {
    found[r] = is_reconstructed(references[r].segment, lines, options) ? 1 : 0;
  });
  std::map<std::string, ReferenceCompleteness> by_kind;
  ReferenceCompleteness all{"all"};
  for (std::size_t r = 0; r < references.size(); ++r) {
    if (references[r].visible_share < options.min_visible) continue;
    ReferenceCompleteness& kind = by_kind[references[r].kind];
    for (ReferenceCompleteness* row : {&kind, &all}) {
      ++row->n_lines;
      row->n_reconstructed += static_cast<std::size_t>(found[r]);
    }
  }
  std::vector<ReferenceCompleteness> rows;
  for (auto& [kind, row] : by_kind) {
    if (kind.empty()) continue;
    row.kind = kind;
    rows.push_back(row);
  }
  rows.push_back(all);
  return rows;
}

}  // namespace

std::vector<std::optional<std::size_t>> reference_of_each(std::span<const JudgedLine> lines,
                                                          std::span<const ReferenceLine> references,
                                                          const ReferenceOptions& options) {
  std::vector<std::optional<std::size_t>> result(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    result[i] = reference_of(lines[i], references, options);
  });
  return result;
}

std::vector<std::optional<double>> reference_errors_m(std::span<const JudgedLine> lines,
                                                      std::span<const ReferenceLine> references,
                                                      const ReferenceOptions& options) {
  const auto assigned = reference_of_each(lines, references, options);
  std::vector<std::optional<double>> errors_m(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!assigned[i] || !has_geometry(lines[i])) continue;
    errors_m[i] = mean_distance_m(lines[i].segment, references[*assigned[i]].segment);
  }
  return errors_m;
}

ReferenceComparison compare_with_references(std::span<const JudgedLine> lines,
                                            std::span<const ReferenceLine> references,
                                            const ReferenceOptions& options) {
  const auto errors_m = reference_errors_m(lines, references, options);
  ReferenceComparison comparison;
  for (const std::string_view line_class : {kNotAligned, kAligned, kTotal}) {
    comparison.classes.push_back(errors_of(lines, errors_m, line_class, options));
  }
  comparison.completeness = completeness_of(lines, references, options);
  return comparison;
}

}  // namespace ridgeline::evaluate
