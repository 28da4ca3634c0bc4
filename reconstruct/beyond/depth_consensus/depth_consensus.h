// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_scorer.h"

#include <limits>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// One of the lines that an aligned match shows.
struct DepthPart {
  std::optional<std::size_t> from,
      to;  ///< evidence where it is cut; empty at the ends of the match
  DepthLine line;
  std::vector<std::size_t> supports;  ///< evidence of it within chance of the line
  bool horizontal = false;            ///< within the scatter of lines that are built horizontal
};

/// The depths along a match that its evidence agrees on.
struct DepthConsensus {
  std::vector<DepthPart> parts;  ///< from the start of the match to its end; one for most
  /// How much the score of the best profile that is quite another one, over a metre away somewhere,
  /// is below; infinity without any.
  double margin = std::numeric_limits<double>::infinity();
};

/// An artificial point of an aligned line proves nothing by itself: where the line is parallel to
/// the epipolar lines, every crossing of it in both images passes the epipolar test, whether the
/// lines meet in space or not. Points that agree do prove something. Nor does a
/// straight segment prove one line: the verges of a gable, the eaves of a stepped row lie on one
/// straight line in both images. This finds the profile, one line or several, in the base segment's
/// projection plane that explains most. Hypotheses: straight_profiles(), gable_profiles(),
/// row_profile(), each with its prior; to its logarithm their score adds
///
///     log(d (1 - prior) + prior * gain * b(distance / its sigma))     per evidence,
///     log(0.3 + 0.7 max_k b((Z - Z_k) / 0.2 m))                       for the height Z of each end,
///     -2.5 log(1 + chi^2 / 3)                                         of the other image's misclosure
///     SurfaceDepth::log_likelihood()                                  of the surface beside the line
///
/// with b(z) = exp(-z^2 / 2) and d = 1, for points above the line however
/// 1 - (1 - 0.1) * meeting * (1 - b): where a line ends at another one in the images it may
/// pass below it, hidden from there on; above it nothing hides it, and it would end there by chance.
/// Evidence at a cut belongs to either line and counts for the better one; other evidence within 6 px
/// of it adds log(1 + prior * (gain - 1) * b) of the better one, which is never below 0.
///
/// The gain is limited, so that it is not the number of points that decides: false ones agree as well,
/// those of an eave with the ground lines that it hides are all on the ground. Z_k are the heights of the
/// lines nearby: eaves, ridges and streets come at few heights.
///
/// Empty without evidence. Ties go to the earlier hypothesis.
std::optional<DepthConsensus> agree_on_depth(const DepthQuestion& question);

}  // namespace ridgeline::reconstruct
