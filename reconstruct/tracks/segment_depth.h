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

/// The line of a segment (the base) with the observations found for it.
struct ProposedTrack : Track {
  SegmentDepth depth;
  double log_odds = 0.0;  ///< of the track versus chance
};

/// Assumed share of the views in which an edge within their image is visible; ours.
inline constexpr double kSeenShare = 0.7;

using IsFree = std::function<bool(const Observation&)>;

/// Finds the line of a segment from the segments of all other views.
///
/// Each segment of another view that lies in the segment's epipolar band and does not run nearly
/// along it gives a hypothesis: the intersection of the projection planes of both segments. The
/// hypothesis predicts the position of the line in the other views, nearest view first. The
/// segments found there multiply the odds of the hypothesis by
///
///     (1 - p) + p N(r; 0, S) / density
///
/// where p is the share of views in which an edge within their image is visible (kSeenShare), r are
/// the residuals across the segment at both ends of its overlap with the prediction, S is their
/// covariance, and density is that of nearly parallel segments around the prediction: where there
/// are many, one of them may fit by chance. A hypothesis starts with the odds p / n of one of n
/// candidates. A match by appearance multiplies the odds by 20; a match with another segment
/// divides them by 20. Each observation refines the heights (least squares), so that the next
/// prediction is sharper.
///
/// The result is the hypothesis with the largest odds among those with three or more views, if its
/// log odds are at least min_log_odds and all hypotheses with other heights together are less
/// likely by min_margin; std::nullopt otherwise.
std::optional<ProposedTrack> propose_track(const SearchedViews& views,
                                           const Observation& reference,
                                           const CandidateOptions& candidates,
                                           const TrackOptions& options,
                                           const IsFree& is_free);

/// Adds further segments in which each view shows pieces of the line of a track. A piece must lie
/// on the line to within its uncertainty and within the part of the line that the track covers, and
/// must not overlap a segment of the same view that is already in the track.
void add_pieces(const SearchedViews& views,
                const TrackOptions& options,
                const IsFree& is_free,
                ProposedTrack& track);

}  // namespace ridgeline::reconstruct
