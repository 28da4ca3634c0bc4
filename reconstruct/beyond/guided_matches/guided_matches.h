// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/ok2011/extract/options.h"
#include "reconstruct/views/candidates.h"
#include "reconstruct/views/scene.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Matches of segments that were extracted in one view alone.
struct GuidedMatches {
  std::array<std::vector<EdgeSegment>, 2> mates;  ///< by the view that shows them
  std::vector<ScoredMatch>
      matches;  ///< by left, then right; ids of mates go on from the pair's segments
};

struct GuideOptions {
  ExtractOptions edges;         ///< what the uncertainty of a mate is stated by
  CandidateOptions candidates;  ///< what a mate may be
  double min_similarity = 0.8;  ///< of the look of a match
};

/// A segment of either view without a mate is looked for in the other view, where the surfaces beside it tell
/// (MatePrediction). A step of colour there (step_along()) becomes its mate if both look alike and if no segment is there
/// already: an edge is often too weak in one of the views, or too near to a stronger one, to be found by itself.
///
/// Mates end where their guides do, so that ends do not count for the look. What stands above the surfaces on both its
/// sides, as a fence does, is not where they tell; it finds its foot there at times.
/// @param known  matches of the pair
GuidedMatches guided_matches(const StereoPair& pair,
                             const Surface& surface,
                             std::span<const LineMatch> known,
                             const GuideOptions& options,
                             const CandidateLook& change_look = {});

}  // namespace ridgeline::reconstruct
