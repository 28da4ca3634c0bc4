// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/adjust_line.h"
#include "reconstruct/estimate/ok2011/candidate_points.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line of an aligned track and its support in addition to its projection planes.
struct LineSupport {
  ObservedTrack track;                   ///< the track, or the part of it that shows the line
  std::vector<CandidatePoint> points{};  ///< artificial points, at most one per region
  /// Points in space that the base and the other segment show on their segments. They lie on the
  /// surface beside the line if that surface is known. Otherwise they are the ends of the segments,
  /// used if the artificial points fix no direction.
  std::vector<UncertainPoint3> ends{};
  /// The points of `ends` as seen in the base view and the other one, conditioned.
  std::vector<std::array<Eigen::Vector2d, 2>> ends_in_images{};
  double sigma_ends_px = 0.0;           ///< standard deviation of `ends` along the line
  bool on_surface = false;              ///< whether `ends` lie on the surface beside the line
  std::optional<double> sigma_slope{};  ///< sigma of the slope if the line is assumed horizontal
  bool points_fix_direction = false;    ///< whether `points` are far enough apart
  bool ambiguous = false;               ///< whether another depth explains the line about as well
};

/// The point of highest weight in each region.
std::vector<CandidatePoint> best_of_regions(std::span<const CandidatePoint> candidates);

/// The line of a match and the points of highest weight in each region (Ok et al. 2011,
/// section 3.1).
LineSupport published_support(const TrackedLines& lines,
                              const ObservedTrack& line,
                              std::span<const int> neighbours);

}  // namespace ridgeline::reconstruct
