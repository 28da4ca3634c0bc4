// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/surface/surface.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Matches of segments that were extracted in one view only.
struct GuidedMatches {
  std::array<std::vector<EdgeSegment>, 2>
      counterparts;  ///< found counterparts, by the view that shows them
  /// In the order of Correspondence::segments(); the indices of counterparts continue those of the
  /// pair's segments.
  std::vector<Correspondence> matches;
};

struct GuideOptions {
  ExtractOptions edges;         ///< determine the stated uncertainty of a counterpart
  CandidateOptions candidates;  ///< which segments may be counterparts
};

/// Searches for the counterparts of unmatched segments of either view in the other view, where the
/// surfaces beside the segment predict them (PredictedCounterpart). A colour step there
/// (step_along()) becomes the counterpart if both look alike and no segment is there already. Such
/// edges are often too weak in one of the views, or too close to a stronger one, to be extracted on
/// their own.
///
/// A counterpart ends where its guide does, so the agreement of their ends is no evidence. A fence,
/// or any other object that rises above the surfaces on both its sides, does not appear where these
/// surfaces predict it; sometimes its foot is found there instead.
/// @param known  the matches of the pair so far
GuidedMatches guided_matches(const StereoPair& pair,
                             const Surface& surface,
                             std::span<const Correspondence> known,
                             const GuideOptions& options,
                             const CandidateAppearance& change_appearance = {});

}  // namespace ridgeline::reconstruct
