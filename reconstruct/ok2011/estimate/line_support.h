// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/estimate/adjust_line.h"
#include "reconstruct/ok2011/estimate/candidate_points.h"
#include "reconstruct/ok2011/estimate/options.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line that an aligned match shows and what it rests on beside its two projection planes.
struct LineSupport {
  ObservedPair seen;                     ///< the match, or the part of it that shows the line
  std::vector<CandidatePoint> points{};  ///< artificial points, one per region at most
  /// What both images show at points of their segments: where the surface beside the line is,
  /// else the ends, where the artificial points fix no direction.
  std::vector<UncertainPoint3> ends{};
  /// The same as seen in the left and the right image.
  std::vector<std::array<Eigen::Vector2d, 2>> ends_in_images{};
  double sigma_ends_px = 0.0;           ///< of these along the line
  bool on_surface = false;              ///< the ends are where the surface is
  std::optional<double> sigma_slope{};  ///< taken as horizontal, as the consensus is
  bool points_fix_direction = false;    ///< they are far enough apart
  bool ambiguous = false;               ///< another depth explains the line about as well
};

/// The point of highest weight in each region.
std::vector<CandidatePoint> best_of_regions(std::span<const CandidatePoint> candidates,
                                            const ReconstructOptions& options);

/// The line of a match and the points of highest weight in each region (Ok et al. 2011, section 3.1).
LineSupport published_support(const StereoLines& lines,
                              const ObservedPair& line,
                              std::span<const int> neighbours,
                              const ReconstructOptions& options);

}  // namespace ridgeline::reconstruct
