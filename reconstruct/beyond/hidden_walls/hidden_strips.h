// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/close_edges/close_lines.h"
#include "reconstruct/views/candidates.h"

#include <array>

namespace ridgeline::reconstruct {

/// Compares lines across strips that only one camera sees: the wall below an eave, the front of a
/// garden wall.
///
/// Whatever is vertical appears with its upper edge farther from the nadir. The camera that faces it
/// sees both edges a few pixels apart, the other one the upper edge alone, with the ground where the
/// wall would be. Of the two edges the *lower* one then looks like it: the ground is beside both.
/// Hence, where both edges of a strip have the same mate and its image shows no such strip, the upper
/// edge is compared anew, with the strip cut out: on the side of the strip what lies beyond the lower
/// edge counts. If that makes it about as similar as the lower edge, the upper edge keeps the better
/// similarity and the lower one loses the candidate.
///
/// @param close  the lines close to others in the left and in the right image
void compare_across_hidden_strips(const SearchedPair& views,
                                  const Radiometry& radiometry,
                                  const std::array<CloseLines, 2>& close,
                                  Candidates& candidates);

}  // namespace ridgeline::reconstruct
