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

/// A true edge: its visible parts in at least two views, in pixels.
struct TrueEdge {
  std::vector<ObservedSegment> runs;
  bool is_aligned = false;  ///< along the epipolar lines in every pair of its views
};

/// The score of tracks against the true edges.
struct TracksScore {
  /// The figures by class and number of images, see TrackCell.
  std::vector<TrackCell> cells;
  std::size_t n_unjudged = 0;                       ///< observations
  std::vector<std::vector<MatchVerdict>> verdicts;  ///< of each observation of each track
};

/// Judges tracks against true edges. score_matches() defines when a segment lies on an edge.
/// A track is assigned to the edge on which it certainly lies in the most views; of several, to the
/// one with the most observations, then to the first one. The observations of a track without an
/// edge are unjudged (texture, shadows). Other observations are
///   correct   if they lie on a visible part of the track's edge;
///   unjudged  if they lie on no edge, in a view that does not show the track's edge or where they
///             continue it beyond its visible part by at most its length;
///   false     otherwise.
/// An edge is found if observations of one track lie on it in at least two views; the views of such
/// tracks are found, too. An edge without any segment counts as missed: the figures include the
/// extraction of segments. Throws std::invalid_argument for a view or segment out of range and for
/// an edge in fewer than two views.
TracksScore score_tracks(std::span<const std::vector<Segment2>> segments_by_view,
                         std::span<const Track> tracks,
                         std::span<const TrueEdge> edges);

}  // namespace ridgeline::evaluate
