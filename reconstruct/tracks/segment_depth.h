// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"
#include "reconstruct/tracks/options.h"
#include "reconstruct/tracks/predicted_line.h"
#include "reconstruct/tracks/searched_views.h"

#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The line of a segment, which is the base, with the observations of it that were found.
struct ProposedTrack : Track {
  SegmentDepth depth;
  double log_odds = 0.0;  ///< of the track against chance
};

/// Share of the views that show an edge if it is in their image; ours.
inline constexpr double kSeenShare = 0.7;

using IsFree = std::function<bool(const Observation&)>;

/// Finds the line of a segment by the segments of all other views.
///
/// Each segment of another view that crosses the segment's epipolar band, not nearly along it,
/// gives a hypothesis: the intersection of their planes. The hypothesis predicts where the other
/// views show the line, nearest view first. What a view shows there multiplies the odds of the
/// hypothesis by
///
///     (1 - p) + p N(r; 0, S) / density
///
/// with the share p of views that show an edge in their image (kSeenShare), the residuals r of the
/// segment across the prediction at both ends of what they share, their covariance S, and the
/// density of nearly parallel segments beside the prediction: where many run, one of them fits by
/// chance. The hypothesis starts with the odds p / n of one of n candidates. A match by its
/// appearance multiplies the odds by 20, a match with another segment divides them. Each
/// observation adds to the heights (least squares), so that the next prediction is sharper.
///
/// The result is the hypothesis of the largest odds with three views or more, if it has
/// min_log_odds, and if all hypotheses of other heights together are less likely by min_margin.
/// Nothing otherwise.
std::optional<ProposedTrack> propose_track(const SearchedViews& views,
                                           const Observation& reference,
                                           const CandidateOptions& candidates,
                                           const TrackOptions& options,
                                           const IsFree& is_free);

/// Adds the pieces in which each view shows the line of a track. A piece lies on the line within
/// chance, within the part that a view of the track shows, and beside no other segment of its view
/// that the track has.
void add_pieces(const SearchedViews& views,
                const TrackOptions& options,
                const IsFree& is_free,
                ProposedTrack& track);

}  // namespace ridgeline::reconstruct
