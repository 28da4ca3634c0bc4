// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/reference_errors.h"

#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/parameter_intervals.h"
#include "evaluate/statistics/summary.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ridgeline::evaluate {
namespace {

/// A line is assigned to the reference line whose image passes this close to both ends of its image
/// segment, in both images.
constexpr double kMaxFromReference_px = 2.0;
/// The covariance of a line is tested only if its reference line passes this close. If it is
/// farther away, the line may belong to another edge beside the true one.
constexpr double kMaxTested_px = 1.0;
constexpr double kGross_m = 1.0;
/// Largest distance and angle of a line from the reference line that it covers.
constexpr double kTolerance_m = 0.3;
constexpr double kMaxFromReference_deg = 5.0;
constexpr double kMinCoveredShare = 0.5;  ///< of a reference line, to count as reconstructed
constexpr double kMinVisibleShare = 0.5;  ///< of a reference line in both images, to be counted

constexpr double kBeyondEnds_px = 5.0;  // an extracted end may continue along a neighbouring edge

/// The larger of the distances of the segment's ends from the image of the reference line; infinite
/// if an end lies more than kBeyondEnds_px beyond the ends of that image.
double distance_in_image(const Segment2& segment_px, const Segment2& reference_px) {
  const double length_px = length(reference_px);
  if (!(length_px > 0.0)) return HUGE_VAL;
  const Eigen::Vector2d along = (reference_px.end - reference_px.start) / length_px;
  double largest = 0.0;
  for (const Eigen::Vector2d& end : {segment_px.start, segment_px.end}) {
    const Eigen::Vector2d offset = end - reference_px.start;
    const double s = offset.dot(along);
    if (s < -kBeyondEnds_px || s > length_px + kBeyondEnds_px) return HUGE_VAL;
    largest = std::max(largest, std::abs(offset.x() * along.y() - offset.y() * along.x()));
  }
  return largest;
}

/// The reference lines projected into one image.
struct ReferenceImage {
  ProjectionMatrix image_from_local;
  std::vector<Segment2> lines_px;
  BoxIndex2 by_place;
};

ReferenceImage reference_image(const ProjectionMatrix& image_from_local,
                               std::span<const ReferenceLine> references) {
  std::vector<Segment2> lines_px;
  for (const ReferenceLine& r : references) {
    lines_px.push_back(project(image_from_local, r.segment));
  }
  BoxIndex2 by_place(lines_px);
  return {image_from_local, std::move(lines_px), std::move(by_place)};
}

/// The reference lines in each base image of the lines. There are few such images, because many
/// lines come from one pair.
std::vector<ReferenceImage> reference_images(std::span<const JudgedLine> lines,
                                             std::span<const ReferenceLine> references) {
  std::vector<ReferenceImage> images;
  for (const JudgedLine& line : lines) {
    if (!line.images) continue;
    const ProjectionMatrix& p = line.images->base().image_from_local;
    const auto is_of_p = [&](const ReferenceImage& i) { return i.image_from_local == p; };
    if (std::none_of(images.begin(), images.end(), is_of_p)) {
      images.push_back(reference_image(p, references));
    }
  }
  return images;
}

std::optional<std::size_t> reference_of(const ImageEvidence& line,
                                        const ReferenceImage& base,
                                        std::span<const ReferenceLine> references,
                                        double max_distance_px) {
  const Segment2& on_base = line.base().px;
  const ImageObservation& other = line.other();
  std::optional<std::size_t> best;
  double nearest_px = max_distance_px;
  for (const std::size_t r : base.by_place.near(on_base, kBeyondEnds_px + nearest_px)) {
    const double on_base_px = distance_in_image(on_base, base.lines_px[r]);
    if (on_base_px > nearest_px) continue;
    const double worse_px = std::max(
        on_base_px,
        distance_in_image(other.px, project(other.image_from_local, references[r].segment)));
    if (worse_px > nearest_px) continue;
    nearest_px = worse_px;
    best = r;
  }
  return best;
}

/// Like reference_of_each(), for the reference lines that pass within this distance.
std::vector<std::optional<std::size_t>> references_within(
    double max_distance_px,
    std::span<const JudgedLine> lines,
    std::span<const ReferenceLine> references) {
  const std::vector<ReferenceImage> images = reference_images(lines, references);
  std::vector<std::optional<std::size_t>> result(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    if (!lines[i].images) return;
    const ImageEvidence& line = *lines[i].images;
    const auto base = std::find_if(images.begin(), images.end(), [&](const ReferenceImage& image) {
      return image.image_from_local == line.base().image_from_local;
    });
    if (base != images.end()) result[i] = reference_of(line, *base, references, max_distance_px);
  });
  return result;
}

/// Mean distance of the segment from the infinite line. The distance is convex along the segment,
/// so where it is not linear, a few samples are accurate to one per cent.
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

/// The distance of a line from its reference line, across it in plan and in height.
struct ErrorParts {
  double mean_square_horizontal_m2 = 0.0, mean_square_vertical_m2 = 0.0, mean_vertical_m = 0.0;
};

/// The error components, from the offsets of the ends, between which they vary linearly. Empty for
/// a steep reference line.
std::optional<ErrorParts> error_parts(const Segment3& segment, const Segment3& reference) {
  constexpr double kMaxSlope = 3.732;  // tan 75 degrees
  const Eigen::Vector3d along = reference.end - reference.start;
  const double plan_m = along.head<2>().norm();
  if (!(std::abs(along.z()) <= kMaxSlope * plan_m) || !(plan_m > 0.0)) return std::nullopt;
  const Eigen::Vector2d u = along.head<2>() / plan_m;
  std::array<double, 2> across_m{};
  std::array<double, 2> above_m{};
  for (const std::size_t end : {0U, 1U}) {
    const Eigen::Vector3d offset = (end == 0 ? segment.start : segment.end) - reference.start;
    across_m[end] = u.x() * offset.y() - u.y() * offset.x();
    above_m[end] = offset.z() - offset.head<2>().dot(u) * along.z() / plan_m;
  }
  const auto mean_square = [](const std::array<double, 2>& v) {
    return (v[0] * v[0] + v[0] * v[1] + v[1] * v[1]) / 3.0;
  };
  return ErrorParts{mean_square(across_m), mean_square(above_m), (above_m[0] + above_m[1]) / 2.0};
}

bool has_geometry(const JudgedLine& line) {
  return line.reconstructed && line.confirmed && in_range(line.segment);
}

bool is_of(const JudgedLine& line, std::string_view line_class) {
  return line_class == kTotal || line.line_class == line_class;
}

/// Squared error of the two ends across the reference line, normalised by the stated covariance;
/// empty if, according to that covariance, a combination of the ends is free of error.
std::optional<double> normalised_square(const JudgedLine& line, const Segment3& reference) {
  const Eigen::Vector3d along = (reference.end - reference.start).normalized();
  const Eigen::Vector3d across = along.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> frame;
  frame << across.transpose(), along.cross(across).transpose();
  Eigen::Matrix<double, 4, 6> by_ends = Eigen::Matrix<double, 4, 6>::Zero();
  by_ends.topLeftCorner<2, 3>() = frame;
  by_ends.bottomRightCorner<2, 3>() = frame;
  Eigen::Vector4d error;
  error << frame * (line.segment.start - reference.start),
      frame * (line.segment.end - reference.start);
  const Eigen::LLT<Eigen::Matrix4d> cov(by_ends * *line.covariance_m2 * by_ends.transpose());
  if (cov.info() != Eigen::Success) return std::nullopt;
  return error.dot(cov.solve(error));
}

/// The errors of a line against its reference line.
struct LineError {
  double mean_m = 0.0;
  std::optional<ErrorParts> parts;
  std::optional<double> normalised_square;
};

std::vector<std::optional<LineError>> line_errors(std::span<const JudgedLine> lines,
                                                  std::span<const ReferenceLine> references) {
  const auto assigned = reference_of_each(lines, references);
  const auto tested = references_within(kMaxTested_px, lines, references);
  std::vector<std::optional<LineError>> errors(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!assigned[i] || !has_geometry(lines[i])) continue;
    const Segment3& reference = references[*assigned[i]].segment;
    errors[i] = {mean_distance_m(lines[i].segment, reference),
                 error_parts(lines[i].segment, reference), std::nullopt};
    if (tested[i] && lines[i].covariance_m2)
      errors[i]->normalised_square = normalised_square(lines[i], reference);
  }
  return errors;
}

void add_parts(std::span<const ErrorParts> parts, ReferenceErrors& result) {
  result.n_parts = parts.size();
  if (parts.empty()) return;
  ErrorParts sum;
  for (const ErrorParts& p : parts) {
    sum.mean_square_horizontal_m2 += p.mean_square_horizontal_m2;
    sum.mean_square_vertical_m2 += p.mean_square_vertical_m2;
    sum.mean_vertical_m += p.mean_vertical_m;
  }
  const auto n = static_cast<double>(parts.size());
  result.rmse_horizontal_m = std::sqrt(sum.mean_square_horizontal_m2 / n);
  result.rmse_vertical_m = std::sqrt(sum.mean_square_vertical_m2 / n);
  result.mean_vertical_m = sum.mean_vertical_m / n;
}

void add_nees(const std::vector<double>& squares, ReferenceErrors& result) {
  constexpr double kMedian = 3.35669;  // median of chi-square with 4 degrees of freedom
  constexpr double kLimit = 18.46683;  // its 99.9 % quantile
  result.n_tested = squares.size();
  if (squares.empty()) return;
  result.median_nees_ratio = *median(squares) / kMedian;
  const auto n_beyond = std::ranges::count_if(squares, [](double s) { return s > kLimit; });
  result.nees_beyond_99_9_share =
      static_cast<double>(n_beyond) / static_cast<double>(squares.size());
}

ReferenceErrors errors_of(std::span<const JudgedLine> lines,
                          std::span<const std::optional<LineError>> errors,
                          std::string_view line_class) {
  ReferenceErrors result;
  result.line_class = line_class;
  std::vector<double> e;
  std::vector<ErrorParts> parts;
  std::vector<double> squares;
  std::size_t gross = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_of(lines[i], line_class)) continue;
    ++result.n_lines;
    if (!errors[i]) continue;
    e.push_back(errors[i]->mean_m);
    if (errors[i]->mean_m > kGross_m) ++gross;
    if (errors[i]->parts) parts.push_back(*errors[i]->parts);
    if (errors[i]->normalised_square) squares.push_back(*errors[i]->normalised_square);
  }
  result.n_on_reference = e.size();
  if (e.empty()) return result;
  const auto n = static_cast<double>(e.size());
  result.rms_m = std::sqrt(sum_of_squares(e) / n);
  result.median_m = median(e);
  result.q95_m = quantile(e, 0.95);
  result.max_m = *std::max_element(e.begin(), e.end());
  result.gross_share = static_cast<double>(gross) / n;
  add_parts(parts, result);
  add_nees(squares, result);
  return result;
}

bool is_reconstructed(const Segment3& reference,
                      std::span<const Segment3> lines,
                      const BoxIndex3& lines_by_place) {
  const Eigen::Vector3d direction = reference.end - reference.start;
  std::vector<ParameterInterval> covered;
  for (const std::size_t i : lines_by_place.near(reference, kTolerance_m)) {
    const Eigen::Vector3d other = lines[i].end - lines[i].start;
    if (acute_angle_rad(direction, other) > kMaxFromReference_deg * kRadPerDeg) continue;
    const auto part = part_near(reference, lines[i], kTolerance_m);
    if (part) covered.push_back(*part);
  }
  return total_length(join(std::move(covered))) >= kMinCoveredShare;
}

std::vector<ReferenceCompleteness> completeness_of(std::span<const JudgedLine> lines,
                                                   std::span<const ReferenceLine> references) {
  std::vector<Segment3> reconstructed;
  for (const JudgedLine& line : lines) {
    if (has_geometry(line)) reconstructed.push_back(line.segment);
  }
  const BoxIndex3 by_place(reconstructed);
  std::vector<char> found(references.size(), 0);
  tbb::parallel_for(std::size_t{0}, references.size(), [&](std::size_t r) {
    found[r] = is_reconstructed(references[r].segment, reconstructed, by_place) ? 1 : 0;
  });
  std::map<std::string, ReferenceCompleteness> by_kind;
  ReferenceCompleteness all{"all"};
  for (std::size_t r = 0; r < references.size(); ++r) {
    if (references[r].visible_share < kMinVisibleShare) continue;
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

std::vector<std::optional<std::size_t>> reference_of_each(
    std::span<const JudgedLine> lines, std::span<const ReferenceLine> references) {
  return references_within(kMaxFromReference_px, lines, references);
}

std::vector<std::optional<double>> reference_errors_m(std::span<const JudgedLine> lines,
                                                      std::span<const ReferenceLine> references) {
  return transformed(line_errors(lines, references), [&](const auto& error) {
    return error ? std::optional(error->mean_m) : std::nullopt;
  });
}

ReferenceComparison compare_with_references(std::span<const JudgedLine> lines,
                                            std::span<const ReferenceLine> references) {
  const auto errors = line_errors(lines, references);
  ReferenceComparison comparison;
  for (const std::string_view line_class : {kNotAligned, kAligned, kTotal}) {
    comparison.classes.push_back(errors_of(lines, errors, line_class));
  }
  comparison.completeness = completeness_of(lines, references);
  return comparison;
}

}  // namespace ridgeline::evaluate
