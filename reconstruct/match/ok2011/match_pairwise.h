// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/match/ok2011/options.h"
#include "reconstruct/scene/scene.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ridgeline::reconstruct {

/// Hooks for extensions of the matching beyond the paper. Each may be empty.
struct MatchExtensions {
  /// Improves on the first radiometry, which comes from the flanks of all segments.
  std::function<Radiometry(const SearchedPair& pair, const Radiometry& first)> radiometry;
  CandidateAppearance appearance;
  /// Changes the candidates, best first, once all of them are known.
  std::function<void(
      const SearchedPair& pair, const Radiometry& radiometry, Candidates& candidates)>
      candidates;
};

/// The outcome of the matching for a left segment.
enum class MatchOutcome : std::uint8_t {
  kMatched,
  kNoCandidate,  ///< no possible counterpart in its epipolar band
  kLowScore,     ///< its best candidate is not probable enough
  kAmbiguous,    ///< two candidates are about equally good
  kNoPair,  ///< too few pairs support its best candidate, and its appearance alone does not suffice
  kLostVote,  ///< its best candidate belongs to another left segment
};
const char* name(MatchOutcome outcome);  ///< "matched", "no_candidate", ...

struct MatchResult {
  std::vector<Correspondence> matches;  ///< in the order of Correspondence::segments()
  std::vector<MatchOutcome> outcomes;   ///< per left segment
};

/// Pair-wise matching of line segments (Ok et al. 2011, section 2).
///
/// Candidates come from the epipolar geometry and the height range; pairs of neighbouring segments
/// are compared with pairs of candidates by eight constraints; the votes of the pairs, iterated to
/// a fixed point, select the matches. Beyond the paper, single lines have a similarity of their own
/// (each side of the line is compared separately) and neighbours support heights near theirs, so
/// that isolated lines are not lost. Fragments of one edge, in either image, may share a
/// counterpart; two edges never do.
///
/// Deterministic for any number of threads. Throws std::invalid_argument for options or heights out
/// of range, matrices that are not finite or define no epipolar geometry, and images of unsupported
/// types or with different numbers of bands.
MatchResult match_pairwise(const StereoPair& pair,
                           const MatchOptions& options = {},
                           const CandidateOptions& candidate_options = {},
                           const MatchExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
