// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/calibration.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/statistics/summary.h"

#include <string>
#include <vector>

namespace ridgeline::evaluate {

struct Stratum {
  Summary summary;  ///< line_class is the label of the stratum, e.g. "2-5"
  Calibration calibration;
};

/// All lines of an evaluation divided by one property.
struct Stratification {
  /// epipolar_angle_deg | kind | length_m | roof_slope_deg | sigma_line_quartile | n_images |
  /// decided_by
  std::string by;
  /// All bins, including empty ones, then "unknown" if lines lack the property. Bins include their
  /// upper bound, so that epipolar angles up to 10 degrees are exactly `aligned`.
  std::vector<Stratum> strata;
};

/// Strata by epipolar angle (0 2 5 10 20 45 90 degrees; with more than two views, the largest over
/// the pairs), kind, length, slope of the steepest plane and quartile of the predicted sigma; if a
/// line has three images or more, also by number of images; if points or place decided a line, also
/// by that evidence. The strata of each property add up to the total, see assert_pooled();
/// std::logic_error is thrown otherwise.
std::vector<Stratification> stratify(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
