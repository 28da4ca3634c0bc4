// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A true 3D line, local metres.
struct ReferenceLine {
  Segment3 segment;
  std::string kind;            ///< ridge, eave, ...; empty if the file does not give it
  double visible_share = 1.0;  ///< share of its length, in the image that shows less of it
};

/// True errors of the lines of a class: e = mean distance of a line from the (infinite) reference
/// line on which its image segments lie. Unlike the distance from LIDAR planes, it includes shifts
/// within a plane, and the reference does not depend on the method that made the line.
struct ReferenceErrors {
  std::string line_class;
  std::size_t n_lines = 0;
  std::size_t n_on_reference = 0;  ///< n of the figures below; the others lie on no reference line
  std::optional<double> rms_m, median_m, q95_m, max_m;
  std::optional<double> gross_share;
  /// Errors across the reference line in plan (horizontal), and in height at the same position in
  /// plan (vertical): root mean squares along each line, then over the lines. `n_parts` is the
  /// number of lines that have them; lines on a reference line steeper than 75 degrees do not.
  std::size_t n_parts = 0;
  std::optional<double> rmse_horizontal_m, rmse_vertical_m, mean_vertical_m;
  /// Normalised squared error of the two ends across the reference line. If the stated covariance
  /// is correct, it follows a chi-square distribution with 4 degrees of freedom; its median divided
  /// by the expected median is then 1, and the share beyond the 99.9 % limit is 0.1 %.
  std::size_t n_tested = 0;
  std::optional<double> median_nees_ratio, nees_beyond_99_9_share;
};

struct ReferenceCompleteness {
  std::string kind;  ///< of the reference lines, or "all"
  std::size_t n_lines = 0, n_reconstructed = 0;
};

struct ReferenceComparison {
  std::vector<ReferenceErrors> classes;             ///< not_aligned, aligned, total
  std::vector<ReferenceCompleteness> completeness;  ///< by kind, sorted by name, then "all"
};

/// Index of the reference line from which each line was made, according to its image segments;
/// empty for a line without images or on no reference line. If there are several, it is the nearest
/// one in the images.
std::vector<std::optional<std::size_t>> reference_of_each(
    std::span<const JudgedLine> lines, std::span<const ReferenceLine> references);

/// True error of each line, metres; empty for a line that has no geometry or lies on no reference
/// line.
std::vector<std::optional<double>> reference_errors_m(std::span<const JudgedLine> lines,
                                                      std::span<const ReferenceLine> references);

ReferenceComparison compare_with_references(std::span<const JudgedLine> lines,
                                            std::span<const ReferenceLine> references);

}  // namespace ridgeline::evaluate
