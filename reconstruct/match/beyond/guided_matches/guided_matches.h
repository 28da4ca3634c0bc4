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
  /// In the order of Correspondence::segments(); the indices of counterparts go on from the pair's
  /// segments.
  std::vector<Correspondence> matches;
};

struct GuideOptions {
  ExtractOptions edges;         ///< the uncertainty of a counterpart is stated as these say
  CandidateOptions candidates;  ///< which segments may be counterparts
};

/// Looks for the counterparts of unmatched segments of either view in the other view, where the
/// surfaces beside the segment predict them (PredictedCounterpart). A step of colour there
/// (step_along()) becomes the counterpart if both look alike and if no segment is there already.
/// Such edges are often too weak in one of the views, or too near to a stronger one, to be found by
/// themselves.
///
/// A counterpart ends where its guide does, so the ends do not count for the appearance. A fence,
/// or another thing that stands above the surfaces on both its sides, is not where these surfaces
/// predict it; at times its foot is found there instead.
/// @param known  the matches of the pair so far
GuidedMatches guided_matches(const StereoPair& pair,
                             const Surface& surface,
                             std::span<const Correspondence> known,
                             const GuideOptions& options,
                             const CandidateAppearance& change_appearance = {});

}  // namespace ridgeline::reconstruct
