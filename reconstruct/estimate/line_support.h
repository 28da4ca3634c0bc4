// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/adjust_line.h"
#include "reconstruct/estimate/candidate_points.h"
#include "reconstruct/estimate/options.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// What an aligned line rests on beside its two projection planes.
struct LineSupport {
  std::vector<CandidatePoint> points;  ///< artificial points, one per region at most
  std::vector<PointOnLine> ends;       ///< of the segments, where the points fix no direction
  std::optional<double> sigma_slope;   ///< taken as horizontal, as the consensus is
  bool points_fix_direction = false;   ///< they are far enough apart
  bool ambiguous = false;              ///< another depth explains the line about as well
};

/// The points of highest weight in each region (Ok et al. 2011, section 3.1); with
/// options.consensus of those that agree on the depth of the line.
/// @param heights_nearby  of the ends of other lines, conditioned frame
LineSupport line_support(const StereoLines& lines,
                         int line,
                         std::span<const int> neighbours,
                         std::span<const double> heights_nearby,
                         const ReconstructOptions& options);

}  // namespace ridgeline::reconstruct
