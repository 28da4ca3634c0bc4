// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/statistics/tolerance_measures.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

// The figures of a class in the terms of standards. They are informative only: distances of lines
// from planes are not checkpoints.

/// Components of the standard uncertainty of the distance of one line (GUM), as root mean squares
/// over the lines, metres.
struct UncertaintyBudget {
  double laser_random_m = 0.0;      ///< independent errors of the points, through the planes' fits
  double laser_systematic_m = 0.0;  ///< SummaryOptions::sigma_sys_m
  /// The excess of plane_sigma_m() over the independent errors: correlated neighbouring points, few
  /// points.
  double plane_fit_m = 0.0;
  /// Uncertainty of the RMS of the class, not of a single line: the standard error of the clustered
  /// bootstrap.
  std::optional<double> sampling_m;

  /// Uncertainty of the distance of one line: laser and plane combined.
  [[nodiscard]] double combined_m() const;
  [[nodiscard]] double expanded_m() const { return 2.0 * combined_m(); }  ///< k = 2
};

/// RMSE of ridges and hips, including the error of the reference, as required by ASPRS Edition 2
/// (2023).
struct AsprsFigures {
  std::size_t n = 0;
  std::optional<double> rmse_horizontal_m, rmse_vertical_m, rmse_3d_m;
  /// The best class that the reference can attest, since the reference must be twice as accurate as
  /// the class.
  double best_class_m = 0.0;
  bool few_checkpoints = false;  ///< n < 30
  bool biased = false;           ///< |mean vertical| above 25 % of the RMSE
};

/// 1.7308 RMSE_H and 1.9600 RMSE_V (FGDC-STD-007.3-1998); empty for fewer than 20 ridges.
struct NssdaFigures {
  std::optional<double> horizontal_m, vertical_m;
};

/// A measure of ISO 19157:2013, annex D.
struct IsoMeasure {
  int id = 0;
  std::string name;
  std::optional<double> value;
  std::string unit;  ///< "m", "1" (a share), "count"
  std::size_t n = 0;
};

struct StandardsBlock {
  std::string line_class;
  UncertaintyBudget budget;
  AsprsFigures asprs;
  NssdaFigures nssda;
  std::vector<IsoMeasure> iso19157;
};

/// One block for each class of the evaluation. If the measures against reference lines at one
/// tolerance are given, `total` also has the rates of missing and of excess items, by length.
std::vector<StandardsBlock> standards_blocks(
    const Evaluation& evaluation, const std::optional<ToleranceMeasures>& against_lines = {});

}  // namespace ridgeline::evaluate
