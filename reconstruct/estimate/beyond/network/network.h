// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/network/junction.h"
#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/geometry/uncertain/pluecker.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line of a track as it enters the common adjustment, in the conditioned frames.
struct NetworkLine {
  ObservedTrack track;
  Vector6d start = Vector6d::Zero();  ///< unit vector
  /// Covariance of `start`, used to find likely meetings at the beginning; empty if unknown.
  std::optional<Matrix6d> start_cov;
  /// Whether the line is assumed to be horizontal, within options.sigma_slope.
  bool is_horizontal = false;
  /// Ends of the base segment and of the other one that are assumed to show the same point.
  std::vector<std::array<Eigen::Vector2d, 2>> ends;
  double sigma_ends_px = 1.0;  ///< standard deviation of each of `ends` along the line
};

/// Two lines that meet in the images that show both.
struct Meeting {
  int first = 0, second = 0;
  Junction junction;
};

struct AdjustedInNetwork {
  UncertainLine3 line;  ///< unit vector on the Pluecker quadric
  int n_meetings = 0;   ///< number of accepted meetings
  double omega = 0.0;   ///< sum of the squared normalised deviations of its images
  /// False if no meeting was offered, the equations were singular or the adjustment did not
  /// converge.
  bool adjusted = false;
};

/// Jointly adjusts all lines, using their images, the accepted meetings, horizontality and
/// corresponding ends for the lines that need them, and the height range as a weak prior for the
/// heights of both ends. Unlike in adjust_line(), every segment enters once, so observations common
/// to several lines are accounted for.
///
/// A meeting is either an inlier with the standard deviation of its junction or an outlier with a
/// constant density over max_miss_m. Expectation maximisation weights the meetings; at the end,
/// those with a posterior probability of at least 0.5 are accepted.
///
/// There are no alternative starts, no conditions between lines and planes or for parallel and
/// perpendicular lines, and heights are not propagated within the adjustment.
///
/// Lines without a chain of meetings between them are independent, so each connected group is one
/// sparse system, and the groups are adjusted in parallel. Results do not depend on the number of
/// threads.
/// @param heights_m  lowest and highest height of objects, local frame
std::vector<AdjustedInNetwork> adjust_network(const ConditionedViews& frames,
                                              std::span<const NetworkLine> lines,
                                              std::span<const Meeting> meetings,
                                              const std::array<double, 2>& heights_m,
                                              const BuildingOptions& options);

}  // namespace ridgeline::reconstruct
