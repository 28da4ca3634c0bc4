// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/matching/match_scoring.h"
#include "evaluate/matching/track_scoring.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/edge_segment.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Throws IoError naming `file` if a match names a segment that does not exist.
void check_segment_ids(const std::string& file,
                       std::span<const Correspondence> matches,
                       const std::array<std::vector<EdgeSegment>, 2>& segments);

/// Reads a matches.csv, whose ids refer to these segments. Throws IoError under the same conditions
/// as read_matches() and check_segment_ids().
std::vector<Correspondence> read_correspondences(
    const std::string& file, const std::array<std::vector<EdgeSegment>, 2>& segments);

/// Compares the matches of a patch with its reference matches; std::nullopt if it has none. Throws
/// IoError for an invalid reference file, for example one with ids of non-existent segments.
std::optional<evaluate::MatchingScore> score_patch_matches(
    const io::Patch& patch,
    const std::array<std::vector<EdgeSegment>, 2>& segments,
    std::span<const Correspondence> matches);

/// Compares the tracks of a patch with its reference tracks; std::nullopt if it has none. The
/// tracks come from the first `n_views` images; the other images are ignored. An edge is aligned if
/// its angle is at most `max_aligned_angle_deg` in every pair of its images.
std::optional<evaluate::TracksScore> score_patch_tracks(
    const io::Patch& patch,
    std::size_t n_views,
    std::span<const std::vector<EdgeSegment>> segments,
    std::span<const Track> tracks,
    double max_aligned_angle_deg);

}  // namespace ridgeline::apps
