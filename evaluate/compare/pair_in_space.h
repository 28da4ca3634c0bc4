// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Two segments are of one line if their directions differ by no more than this, if they run side
/// by side over this share of the shorter one, and if they are no farther apart there.
inline constexpr double kMaxPairAngle_deg = 5.0;
inline constexpr double kMinPairOverlap = 0.5;
inline constexpr double kMaxPairDistance_m = 1.0;

/// Pairs of indices of segments of one line, each segment in one pair at most, such that the sum of
/// their distances is the smallest, one without a partner counting kMaxPairDistance_m; ascending by
/// the first index. Segments without length are in none. Where about 700 segments and more are so
/// close together, the closest ones are paired first.
std::vector<std::pair<std::size_t, std::size_t>> pair_in_space(std::span<const Segment3> a,
                                                               std::span<const Segment3> b);

}  // namespace ridgeline::evaluate
