// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/tracks/options.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The tracks of a scene; each one collects the segments of all views that show the same edge.
///
/// First, each segment of each view proposes the track of its line over three or more views
/// (propose_track()). The proposals are accepted in the order of their odds, and each segment is in
/// at most one track; a proposal that has lost a segment to another track is recomputed without it.
/// Then the matches by appearance whose two segments are both left become tracks of two views. If a
/// segment has such matches with several views, nearly along the epipolar lines of all of them,
/// they form one track, because geometry cannot determine the depth there.
///
/// If possible, the first two observations of a track belong to a pair that was matched, so that
/// the data of the pair (its surface) can be used.
/// @param pairs  the matches by appearance
/// The result is the same for any number of threads. Throws std::invalid_argument for options out
/// of range.
std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const MatchedPair> pairs,
                             const CandidateOptions& candidates = {},
                             const TrackOptions& options = {});

}  // namespace ridgeline::reconstruct
