// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_scorer.h"

#include <limits>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The depth of an aligned match that its evidence agrees on.
struct DepthConsensus {
  DepthLine line;
  std::vector<std::size_t> supports;  ///< evidence within chance of the line
  bool horizontal = false;            ///< within the scatter of lines that are built horizontal
  /// How much the score of the best line that is quite another one, over a metre away at an end, is
  /// below; infinity without any.
  double margin = std::numeric_limits<double>::infinity();
};

/// An artificial point of an aligned line proves nothing by itself: where the line is parallel to
/// the epipolar lines, every crossing of it in both images passes the epipolar test, whether the
/// lines meet in space or not. Points that agree do prove something. This finds the line in the base
/// segment's projection plane that explains most. Hypotheses are lines through any two pieces of
/// evidence, the horizontal line through each, and those that the strips beside the match speak for
/// (FlankCorrelation). The logarithm of the prior is
///
///     log(h b(slope / sigma_slope) + (1 - h) r(slope))                h the share of horizontal lines,
///
/// with r the slopes of roofs, and of streets. To it their score adds
///
///     log(d (1 - prior) + prior * gain * b(distance / its sigma))     per evidence,
///     log(0.3 + 0.7 max_k b((Z - Z_k) / sigma_height))                for the height Z of each end,
///     -2.5 log(1 + chi^2 / 3)                                         of the other image's misclosure
///     FlankCorrelation::log_likelihood()                              of the strips beside the line
///
/// with b(z) = exp(-z^2 / 2) and d = 1, for points above the line however
/// 1 - (1 - doubt_above) * meeting * (1 - b): where a line ends at another one in the images it may
/// pass below it, hidden from there on; above it nothing hides it, and it would end there by chance.
///
/// The gain is limited, so that it is not the number of points that decides: false ones agree as well,
/// those of an eave with the ground lines that it hides are all on the ground. Z_k are the heights of
/// the lines nearby: eaves, ridges and streets come at few heights.
///
/// Empty without evidence. Ties go to the earlier hypothesis.
std::optional<DepthConsensus> agree_on_depth(const DepthQuestion& question);

}  // namespace ridgeline::reconstruct
