// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <optional>
#include <span>
#include <string>

namespace ridgeline::evaluate {

/// Whether lines and cloud can be in the same coordinate frame at all.
struct FrameCheck {
  bool same_frame = true;
  std::optional<double> median_distance_m;  ///< of the evaluated lines
  std::optional<double> near_share;  ///< share of the lines with a geometry that are near points
  std::string reason;                ///< one clause; empty if the frame is the same
};

/// Lines and cloud are not in the same frame if the median distance is above 20 times
/// `tolerance_m`, or if fewer than 5 % of the lines are near the cloud. The check passes if no line
/// has a geometry. Throws std::invalid_argument unless tolerance_m > 0.
FrameCheck check_frame(std::span<const LineEvaluation> lines, double tolerance_m);

}  // namespace ridgeline::evaluate
