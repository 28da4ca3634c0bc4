// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/network/junction.h"
#include "reconstruct/beyond/options.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "reconstruct/views/conditioned_view.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A matched line as it enters the adjustment of all, in the conditioned frames.
struct NetworkLine {
  ObservedPair seen;
  Vector6d start = Vector6d::Zero();  ///< unit vector
  /// Says which meetings are likely to begin with; none where nothing is known of it.
  std::optional<Matrix6d> start_cov;
  /// Taken as horizontal, within options.sigma_slope.
  bool is_horizontal = false;
  /// Ends of the left and the right segment that are taken to show the same point.
  std::vector<std::array<Eigen::Vector2d, 2>> ends;
  double sigma_ends_px = 1.0;  ///< of each of them along the line
};

/// Two lines that meet in both images.
struct Meeting {
  int first = 0, second = 0;
  Junction junction;
};

struct AdjustedInNetwork {
  UncertainLine3 line;    ///< unit vector on the Pluecker quadric
  int n_meetings = 0;     ///< accepted
  double omega = 0.0;     ///< of its image conditions, squared normalised deviations
  bool adjusted = false;  ///< false: no meeting offered, equations singular or not converged
};

/// All lines in one adjustment by their images, the accepted meetings, horizontality and
/// corresponding ends where they rest on these, and the range of heights as a weak prior of the heights
/// of both ends. Unlike in adjust_line() every segment enters once, so that what lines have in common is
/// accounted for.
///
/// Meetings are inliers of the standard deviation of their junction or outliers of a constant density
/// over max_miss_m: expectation maximisation, then a hard decision at the posterior probability 0.5.
///
/// There are no alternative starts, no conditions between lines and planes or of parallel and
/// perpendicular lines, and no heights that are carried on within the adjustment.
///
/// Lines without a chain of meetings between them are independent: one sparse system for each group,
/// groups in parallel. Results do not depend on the number of threads.
/// @param heights_m  lowest and highest height of objects, local frame
std::vector<AdjustedInNetwork> adjust_network(const StereoViews& stereo,
                                              std::span<const NetworkLine> lines,
                                              std::span<const Meeting> meetings,
                                              const std::array<double, 2>& heights_m,
                                              const BuildingOptions& options);

}  // namespace ridgeline::reconstruct
