// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/candidate_points.h"
#include "reconstruct/estimate/options.h"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Points closer together along the segment than this share of it fix no direction.
inline constexpr double kSmallestBase = 0.2;

/// A point that a line may pass through, in the conditioned object frame.
struct DepthEvidence {
  Eigen::Vector3d x;
  Eigen::Matrix3d cov;
  double parameter = 0.0;  ///< along the base segment, 0 at its start and 1 at its end
  double prior = 0.5;      ///< probability that it is on the line, before the others are heard
  /// Weight of a point where another line seems to meet this one; 0 for what the ends of the line's
  /// own segments show.
  double meeting = 0.0;
};

/// The depths along a line that its evidence agrees on.
struct DepthConsensus {
  std::vector<bool> supports;  ///< by evidence: within chance of the line
  bool horizontal = false;     ///< within the scatter of lines that are built horizontal
  /// How much the score of the best line that is quite another one, over a metre away at an end, is
  /// below; infinity without any.
  double margin = std::numeric_limits<double>::infinity();
};

/// An artificial point of an aligned line proves nothing by itself: where the line is parallel to
/// the epipolar lines, every crossing of it in both images passes the epipolar test, whether the
/// lines meet in space or not (system.md 8). Points that agree do prove something. This finds the
/// line in the base segment's projection plane that explains most: hypotheses are the lines through
/// any two pieces of evidence and the horizontal one through each; their score is the sum of
///
///     log(d (1 - prior) + prior * gain * b(distance / its sigma))     per evidence,
///     log(h * b(slope / sigma_slope) + (1 - h) * b(slope / 0.6))      h the share of horizontal lines,
///     log(0.05 + 0.95 max_k b((Z - Z_k) / sigma_height))              for the height Z of each end,
///     -chi^2 / 2                                                      of the other image's misclosure
///
/// with b(z) = exp(-z^2 / 2) and d = 1, for points above the line however
/// 1 - (1 - doubt_above) * meeting * (1 - b): where a line ends at another one in the images it may
/// pass below it, hidden from there on; above it nothing hides it, and it would end there by chance.
///
/// The gain is small, so that it is not the number of points that decides: false ones agree as well,
/// those of an eave with the ground lines that it hides are all on the ground. Z_k are the heights of
/// the lines nearby: eaves, ridges and streets come at few heights.
///
/// @param heights_nearby  Z_k in the conditioned frame; without any that term is left out
/// Empty without evidence. Ties go to the earlier hypothesis.
std::optional<DepthConsensus> agree_on_depth(const StereoLines& lines,
                                             int line,
                                             std::span<const DepthEvidence> evidence,
                                             std::span<const double> heights_nearby,
                                             const ReconstructOptions& options);

}  // namespace ridgeline::reconstruct
