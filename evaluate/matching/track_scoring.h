// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/matching/match_scoring.h"
#include "evaluate/statistics/track_counts.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/track.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A true edge: its visible runs in the views that show it, at least two views. Pixels.
struct TrueEdge {
  std::vector<ObservedSegment> runs;
  bool is_aligned = false;  ///< along the epipolar lines of every pair of its views
};

/// What the true edges say of tracks.
struct TracksScore {
  /// The figures of each class and number of images, see TrackCell.
  std::vector<TrackCell> cells;
  std::size_t n_unjudged = 0;                       ///< observations
  std::vector<std::vector<MatchVerdict>> verdicts;  ///< of each observation of each track
};

/// Judges tracks by true edges. A segment lies on an edge as in score_matches().
/// The edge of a track is the one that it certainly lies on in most views; of several, the one that
/// most of its observations lie on, then the first one. The observations of a track without an edge
/// are unjudged (texture, shadows). Of the others
///   correct   lie on a run of the track's edge;
///   unjudged  lie on no edge, in a view that has no run of the track's edge or where they continue
///             one beyond its visible part by at most its length;
///   false     are all others.
/// An edge is found if observations of one track lie on it in two views at least; the views of such
/// tracks are found, too. An edge that no segment shows counts as missed: the figures include the
/// extraction of segments. Throws std::invalid_argument for a view or a segment out of range and
/// for an edge in fewer than two views.
TracksScore score_tracks(std::span<const std::vector<Segment2>> segments_by_view,
                         std::span<const Track> tracks,
                         std::span<const TrueEdge> edges);

}  // namespace ridgeline::evaluate
