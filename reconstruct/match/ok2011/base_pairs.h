// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Smallest enclosed angle of a pair, as in the t-term of Ok et al. 2011, Eq. 6.
inline constexpr double kMinPairAngle_deg = 10.0;

/// Two segments of one image that may meet in object space; first < second.
struct BasePair {
  int first = 0;
  int second = 0;
  friend bool operator==(const BasePair&, const BasePair&) = default;
  friend auto operator<=>(const BasePair&, const BasePair&) = default;
};

/// The reference pairs of an image (Ok et al. 2011, section 2), in ascending order. The acute angle
/// of a pair is above kMinPairAngle_deg. The distance of its segments and the distances of their
/// intersection from both are within a radius. The radius grows per segment until it has
/// three partners, so that isolated lines find some. If there are more than 15, the nearest are
/// kept. A pair that either member keeps is kept.
std::vector<BasePair> base_pairs(std::span<const Segment2> segments);

}  // namespace ridgeline::reconstruct
