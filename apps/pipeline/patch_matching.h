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

/// Reads a matches.csv, whose ids are those of these segments. Throws IoError as read_matches() and
/// check_segment_ids().
std::vector<Correspondence> read_correspondences(
    const std::string& file, const std::array<std::vector<EdgeSegment>, 2>& segments);

/// Compares the matches of a patch with its reference matches; nothing if the patch has none.
/// Throws IoError for a fault of the reference file, for example ids that no segments have.
std::optional<evaluate::MatchingScore> score_patch_matches(
    const io::Patch& patch,
    const std::array<std::vector<EdgeSegment>, 2>& segments,
    std::span<const Correspondence> matches);

/// What the reference tracks of the patch say of tracks; empty if it has none. The first `n_views`
/// images are those that the tracks are of; of the others nothing counts. An edge is aligned up to
/// this angle in every pair of its images.
std::optional<evaluate::TracksScore> score_patch_tracks(
    const io::Patch& patch,
    std::size_t n_views,
    std::span<const std::vector<EdgeSegment>> segments,
    std::span<const Track> tracks,
    double max_aligned_angle_deg);

}  // namespace ridgeline::apps
