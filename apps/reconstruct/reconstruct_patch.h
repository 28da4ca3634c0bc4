// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/patch.h"
#include "reconstruct/estimate/options.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/match/options.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::apps {

/// The matched lines of a patch in 3D, as a file holds them: in the CRS, with class, status,
/// covariance and the image segments that they were made from. Id = number of the match, the same
/// for all methods; "17.1", "17.2", ... for the parts of match 17 that shows several lines. A line
/// without geometry keeps its place with coordinates that are not finite.
/// Pair connections are those of the matches; points outside of the patch's heights are not used.
io::LineSet reconstruct_patch(const io::PatchFile& patch,
                              const std::array<std::vector<EdgeSegment>, 2>& segments,
                              const std::vector<LineMatch>& matches,
                              const std::array<cv::Mat, 2>& images,
                              const reconstruct::ReconstructOptions& options,
                              const reconstruct::MatchOptions& match_options);

}  // namespace ridgeline::apps
