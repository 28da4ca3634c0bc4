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
  std::string kind;            ///< ridge, eave, ...; empty if the file does not say
  double visible_share = 1.0;  ///< of its length, in the image that shows less of it
};

struct ReferenceOptions {
  /// A line belongs to the reference line whose image passes this close to both ends of its image
  /// segment, in both images.
  double max_distance_px = 2.0;
  /// ... and this close if the covariance is tested: farther off it may be another edge beside it.
  double max_tested_px = 1.0;
  double gross_m = 1.0;
  /// A reference line counts as reconstructed if lines within this distance ...
  double tolerance_m = 0.3;
  double max_angle_deg = 5.0;  ///< ... and angle ...
  double min_covered = 0.5;    ///< ... cover this share of its length,
  double min_visible = 0.5;    ///< and is counted if both images show this share of it.
};

/// True errors of the lines of a class: e = mean distance of a line from the (infinite) reference
/// line that its image segments lie on. Unlike the distance from LIDAR planes it sees shifts within
/// a plane, and the reference does not depend on the method that made the line.
struct ReferenceErrors {
  std::string line_class;
  std::size_t n_lines = 0;
  std::size_t n_on_reference = 0;  ///< n of the figures below; the others lie on no reference line
  std::optional<double> rms_m, median_m, q95_m, max_m;
  std::optional<double> gross_share;
  /// Across the reference line in plan and, at the same place in plan, in height: root mean squares along each line,
  /// then over the lines. Reference lines steeper than 75 degrees have neither.
  std::size_t n_parts = 0;
  std::optional<double> rmse_horizontal_m, rmse_vertical_m, mean_vertical_m;
  /// Normalised squared error of the two ends across the reference line, chi-square with 4 degrees of
  /// freedom if the stated covariance is right: median over its expectation (1) and share beyond the
  /// 99.9 % limit (0.1 %).
  std::size_t n_tested = 0;
  std::optional<double> median_nees_ratio, nees_beyond_99_9_share;
};

struct ReferenceCompleteness {
  std::string kind;  ///< of the reference lines; "all"
  std::size_t n_lines = 0, n_reconstructed = 0;
};

struct ReferenceComparison {
  std::vector<ReferenceErrors> classes;             ///< not_aligned, aligned, total
  std::vector<ReferenceCompleteness> completeness;  ///< by kind in order of name, then "all"
};

/// Index of the reference line that each line was made from, by its image segments; empty for a
/// line without images or on none. Of several the one nearest in the images.
std::vector<std::optional<std::size_t>> reference_of_each(std::span<const JudgedLine> lines,
                                                          std::span<const ReferenceLine> references,
                                                          const ReferenceOptions& options = {});

/// True error of each line, metres; empty for a line without geometry or on no reference line.
std::vector<std::optional<double>> reference_errors_m(std::span<const JudgedLine> lines,
                                                      std::span<const ReferenceLine> references,
                                                      const ReferenceOptions& options = {});

ReferenceComparison compare_with_references(std::span<const JudgedLine> lines,
                                            std::span<const ReferenceLine> references,
                                            const ReferenceOptions& options = {});

}  // namespace ridgeline::evaluate
