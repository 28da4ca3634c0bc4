// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Two segments are assumed to show the same line if their directions differ by at most this angle,
/// if they run side by side over at least this share of the shorter one, and if they are at most
/// this far apart there.
inline constexpr double kMaxPairAngle_deg = 5.0;
inline constexpr double kMinPairOverlap = 0.5;
inline constexpr double kMaxPairDistance_m = 1.0;

/// Pairs of indices of segments of the same line, each segment in at most one pair, such that the
/// sum of the distances is smallest, with kMaxPairDistance_m for a segment without a partner;
/// ascending by the first index. Segments of zero length are not paired. In dense groups of about
/// 700 segments or more, the closest ones are paired first.
std::vector<std::pair<std::size_t, std::size_t>> pair_in_space(std::span<const Segment3> a,
                                                               std::span<const Segment3> b);

}  // namespace ridgeline::evaluate
