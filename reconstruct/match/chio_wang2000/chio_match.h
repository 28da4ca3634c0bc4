// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/match/chio_wang2000/acquisition.h"
#include "reconstruct/match/chio_wang2000/core.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/match/chio_wang2000/linked_line.h"
#include "reconstruct/match/chio_wang2000/options.h"
#include "reconstruct/scene/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line in object space and how it was acquired.
struct ChioLine {
  Correspondence match;        ///< the initial link; its score is the similarity of the appearance
  std::vector<int> fragments;  ///< further right segments linked to it
  Acquired acquired;
  ChainSummary chain;              ///< chain of the initial link
  std::optional<FittedLine> line;  ///< line through the reliable points of all links, local frame
};

struct ChioResult {
  std::vector<ChioLine> lines;        ///< ascending by left segment, at most one for each
  std::vector<ChioOutcome> outcomes;  ///< per left segment
};

/// Iterative matching and linking of line segments in object space (Chio and Wang 2000): Core finds
/// the candidates that pass its screening, the four processes choose among them from the strongest
/// structure outwards, further fragments of the right edge are linked and one 3D line is fitted to
/// all reliable points. Segments along the epipolar lines are not matched.
///
/// @param candidate_options  options of the search for candidates
/// The result is the same for any number of threads. Throws std::invalid_argument under the same
/// conditions as match_pairwise().
ChioResult chio_match(const StereoPair& pair,
                      const ChioOptions& options = {},
                      const CandidateOptions& candidate_options = {},
                      const ChioExtensions& beyond = {});

/// The matches of the lines.
std::vector<Correspondence> matches_of(const ChioResult& result);

}  // namespace ridgeline::reconstruct
