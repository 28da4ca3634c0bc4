// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/depth_consensus/depth_scorer.h"

#include <limits>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// One of the lines that an aligned track shows.
struct DepthPart {
  /// Indices of the evidence where the track is cut; empty at the ends of the track.
  std::optional<std::size_t> from, to;
  DepthLine line;
  std::vector<std::size_t> supports;  ///< the evidence that agrees with the line within chance
  /// Whether its slope is within the scatter of horizontal lines.
  bool horizontal = false;
};

/// The depths along a track on which its evidence agrees.
struct DepthConsensus {
  std::vector<DepthPart> parts;  ///< from the start of the track to its end; mostly one
  /// Score of the best profile minus that of the best profile that is more than a metre away from
  /// it somewhere; infinite if there is no such profile.
  double margin = std::numeric_limits<double>::infinity();
};

/// A single artificial point of an aligned line proves nothing: if the line is parallel to the
/// epipolar lines, each of its crossings in both images passes the epipolar test, whether the lines
/// meet in space or not. Several points that agree do prove something. A straight segment need not
/// be one line in space: the verges of a gable or the eaves of a stepped row lie on one straight
/// line in both images.
///
/// This function finds the profile, one line or several, in the base segment's projection plane
/// that explains the evidence best. The hypotheses are straight_profiles(), gable_profiles() and
/// row_profile(). The score of a hypothesis is the logarithm of its prior plus
///
///     log(d (1 - prior) + prior * gain * b(distance / its sigma))     per evidence,
///     log(0.3 + 0.7 max_k b((Z - Z_k) / 0.2 m))                       for each end's height Z,
///     -2.5 log(1 + chi^2 / 3)                     of the other image's misclosure
///     SurfaceDepth::log_likelihood()              of the surface beside the line
///
/// with b(z) = exp(-z^2 / 2) and d = 1. For points above the line, d = 1 - (1 - 0.1) * meeting * (1
/// - b): if another line ends at this one in the images, it may pass below this one, hidden from
/// there on. Above this one, nothing hides it, so it would end there only by chance. Evidence at a
/// cut belongs to either line and counts for the better one. Other evidence within 6 px of the cut
/// adds log(1 + prior * (gain - 1) * b) for the better one, which is never below 0.
///
/// The gain is limited so that the number of points alone does not decide, because false points can
/// agree as well: where an eave hides ground lines, the points that it forms with them are all on
/// the ground. Z_k are the heights of nearby lines, because eaves, ridges and streets occur at few
/// heights.
///
/// Empty without a hypothesis. Ties go to the earlier hypothesis.
std::optional<DepthConsensus> agree_on_depth(const DepthQuestion& question);

}  // namespace ridgeline::reconstruct
