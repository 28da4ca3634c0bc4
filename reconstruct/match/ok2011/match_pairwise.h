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

/// The places where extensions beyond the paper enter the matching. Each may be empty.
struct MatchExtensions {
  /// Gives a better radiometry than the first one, which comes from the flanks of all segments.
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
  kNoCandidate,  ///< no right segment in its epipolar band that could be it
  kLowScore,     ///< its best candidate does not look or fit well enough
  kAmbiguous,    ///< two candidates are about as good
  kNoPair,       ///< no pair supports its best candidate, and its appearance alone does not suffice
  kLostVote,     ///< its best candidate belongs to another left segment
};
const char* name(MatchOutcome outcome);  ///< "matched", "no_candidate", ...

struct MatchResult {
  std::vector<Correspondence> matches;  ///< in the order of Correspondence::segments()
  std::vector<MatchOutcome> outcomes;   ///< per left segment
};

/// Pair-wise matching of line segments (Ok et al. 2011, section 2).
///
/// Candidates come from the epipolar geometry and the range of heights; pairs of neighbouring
/// segments are compared with pairs of candidates by eight constraints; the votes of the pairs,
/// iterated to a fixed point, decide. Beyond the paper, single lines have a similarity of their own
/// (both sides of the line compared separately) and neighbours support heights near theirs, so that
/// isolated lines are not lost. Fragments of one edge, in either image, may share a counterpart;
/// two edges never do.
///
/// Deterministic for any number of threads. Throws std::invalid_argument for options or heights out
/// of range, matrices that are not finite or without epipolar geometry, and images of other types
/// or different numbers of bands.
MatchResult match_pairwise(const StereoPair& pair,
                           const MatchOptions& options = {},
                           const CandidateOptions& candidate_options = {},
                           const MatchExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
