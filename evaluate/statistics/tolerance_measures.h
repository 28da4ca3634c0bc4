// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "reconstruct/geometry/segment.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

struct ToleranceOptions {
  std::vector<double> tolerances_m = {0.05, 0.10, 0.25, 0.50, 1.00};
  double max_angle_deg = 5.0;  ///< between a line and a reference line that it may match
};

/// The tolerances of ToleranceOptions together with 1, 2 and 5 ground sampling distances,
/// ascending. Throws std::invalid_argument unless gsd_m > 0.
std::vector<double> tolerances_with_gsd(double gsd_m);

/// Length-weighted measures at one tolerance: L is the length of a line, r the share of it that
/// lies within the tolerance of the reference.
struct ToleranceMeasures {
  double tolerance_m = 0.0;
  std::optional<double> precision;  ///< sum L r / sum L; empty if there are no lines
  /// Covered length of the reference lines / their length, overlaps counted once; empty if there
  /// are no reference lines.
  std::optional<double> completeness;
  std::optional<double> f_score;  ///< 2 P R / (P + R), 0 if both are 0
  /// Length of the lines within tolerance / length of reference that they cover: above 1 for
  /// duplicates. Empty if they cover nothing.
  std::optional<double> redundancy;
  /// LIMAP's figures (Liu et al. 2023), from the samples at (k + 0.5) / 1000 of a line and without
  /// the condition on direction. R is a length, not a ratio, and is increased by duplicate lines if
  /// it is a sum over lines; P counts a line if a single sample of it is within tolerance.
  double limap_r_m = 0.0;
  std::optional<double> limap_p_percent;  ///< empty if there are no lines
};

/// Measures lines against true 3D lines. r is the share of a line within the tolerance of a
/// reference segment (not beyond its ends) whose direction is within max_angle_deg. limap_r_m sums
/// over the reference lines, as LIMAP does for CAD models. The intervals are solved for, not
/// sampled; an R-tree finds the neighbours. Returns one result per tolerance, in the order of the
/// tolerances. Throws std::invalid_argument for a segment that is not finite or a tolerance <= 0.
std::vector<ToleranceMeasures> measure_against_lines(std::span<const Segment3> lines,
                                                     std::span<const Segment3> references,
                                                     const ToleranceOptions& options);

/// Measures the evaluated lines against their LIDAR planes. r is the share of a line within the
/// tolerance of its plane (of both for a ridge), times the plane's coverage: how much of the line
/// is covered is known, but not which part. There is no completeness. limap_r_m sums over the lines
/// and ignores coverage. Throws std::invalid_argument for a tolerance <= 0.
std::vector<ToleranceMeasures> measure_against_planes(std::span<const LineEvaluation> lines,
                                                      const ToleranceOptions& options);

}  // namespace ridgeline::evaluate
