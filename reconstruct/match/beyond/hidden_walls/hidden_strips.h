// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"

namespace ridgeline::reconstruct {

/// Compares lines across strips that only one camera sees, such as the wall below an eave or the
/// front of a garden wall.
///
/// The upper edge of a wall appears farther from the nadir than its lower edge. The camera that
/// faces the wall sees both edges a few pixels apart. The other camera sees the upper edge only,
/// with the ground where the wall would be. The *lower* edge then resembles this edge more than the
/// upper one does, because the ground is beside both. So, if both edges of a strip have the same
/// counterpart and the image of the counterpart shows no such strip, the upper edge is compared
/// again with the strip cut out: on the side of the strip, the image beyond the lower edge is
/// compared. If the upper edge is then about as similar as the lower edge, the upper edge keeps the
/// better similarity and the lower edge loses the candidate.
void compare_across_hidden_strips(const SearchedPair& views,
                                  const Radiometry& radiometry,
                                  Candidates& candidates);

}  // namespace ridgeline::reconstruct
