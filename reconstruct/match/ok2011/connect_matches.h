// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/scene/scene.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The pair connections of matched lines, in ascending order (i < k). They are base pairs of the
/// left image whose counterparts form a pair in the right one, with the same enclosed angle to
/// within kMaxPairTurn_deg times relief_spread(), and with intersection points within
/// kMaxPairEpipolar_px of each other's epipolar lines. Only the geometry of the matches is used, so
/// that matches of any origin can be connected. Fragments that share a counterpart are not
/// connected with each other. `matches` index into the segments. Throws std::invalid_argument for
/// an index out of range.
std::vector<PairConnection> connect_matches(const StereoPair& pair,
                                            std::span<const Correspondence> matches);

}  // namespace ridgeline::reconstruct
