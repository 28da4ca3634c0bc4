// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Smallest angle enclosed by a pair, as in the t-term of Ok et al. 2011, Eq. 6.
inline constexpr double kMinPairAngle_deg = 10.0;

/// Two segments of one image that may meet in object space; first < second.
struct BasePair {
  int first = 0;
  int second = 0;
  friend bool operator==(const BasePair&, const BasePair&) = default;
  friend auto operator<=>(const BasePair&, const BasePair&) = default;
};

/// The reference pairs of an image (Ok et al. 2011, section 2), in ascending order. The acute angle
/// between the segments of a pair exceeds kMinPairAngle_deg. The distance between the segments and
/// the distances of their intersection from both lie within a radius. For each segment, the radius
/// grows until there are three partners, so that isolated lines find some. If there are more than
/// 15, the nearest are kept. A pair is kept if either member keeps it.
std::vector<BasePair> base_pairs(std::span<const Segment2> segments);

}  // namespace ridgeline::reconstruct
