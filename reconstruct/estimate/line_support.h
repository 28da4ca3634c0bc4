// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/adjust_line.h"
#include "reconstruct/estimate/candidate_points.h"
#include "reconstruct/estimate/options.h"
#include "reconstruct/geometry/flank_strips.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line that an aligned match shows and what it rests on beside its two projection planes.
struct LineSupport {
  ObservedPair seen;                   ///< the match, or the part of it that shows the line
  std::vector<CandidatePoint> points;  ///< artificial points, one per region at most
  /// What both images show at points of their segments: where the strips beside the line correlate,
  /// else the ends, where the artificial points fix no direction.
  std::vector<UncertainPoint3> ends;
  /// The same as seen in the left and the right image.
  std::vector<std::array<Eigen::Vector2d, 2>> ends_in_images;
  bool has_flanks = false;            ///< the ends are where the strips correlate
  std::optional<double> sigma_slope;  ///< taken as horizontal, as the consensus is
  bool points_fix_direction = false;  ///< they are far enough apart
  bool ambiguous = false;             ///< another depth explains the line about as well
};

/// The line of a match and the points of highest weight in each region (Ok et al. 2011, section
/// 3.1); with options.consensus the lines, mostly one, and the points that agree on the depth of
/// each; see agree_on_depth().
/// @param heights_nearby  of the ends of other lines, conditioned frame
/// @param strips          beside the match; null if not at hand
std::vector<LineSupport> line_support(const StereoLines& lines,
                                      const ObservedPair& line,
                                      std::span<const int> neighbours,
                                      std::span<const double> heights_nearby,
                                      const FlankStrips* strips,
                                      const ReconstructOptions& options);

}  // namespace ridgeline::reconstruct
