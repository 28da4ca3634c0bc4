// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/tracks/options.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// What the views of a scene show of one edge each.
///
/// First, each segment of each view proposes the track of its line over three views or more
/// (propose_track()). The proposals are taken in the order of their odds, and each segment is in
/// one track; a proposal that has lost a segment is made again without it. Then the matches by
/// their appearance whose segments are both left make tracks of two views. If one segment has such
/// matches with several views, nearly along the epipolar lines of all of them, it is one track,
/// because geometry tells no depth there.
///
/// The first two observations of a track are of a pair that was matched, if its views are of one,
/// so that what is known of a pair (its surface) can be used.
/// @param pairs  the matches by their appearance
/// The result is the same for any number of threads. Throws std::invalid_argument for options out
/// of range.
std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const MatchedPair> pairs,
                             const CandidateOptions& candidates = {},
                             const TrackOptions& options = {});

}  // namespace ridgeline::reconstruct
