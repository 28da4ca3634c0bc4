// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_overlap.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/match/chio_wang2000/edge_chain.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/match/chio_wang2000/options.h"
#include "reconstruct/scene/scene.h"

#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {

/// The outcome of the matching for a left segment. If its candidates fail for several reasons, the
/// last one in this order is given.
enum class ChioOutcome : std::uint8_t {
  kMatched,
  kNoCandidate,         ///< no right segment in its epipolar band
  kEpipolarDegenerate,  ///< it runs along the epipolar line
  kFewPieces,           ///< too few reliable edge pieces
  kAzimuth,             ///< directions differ
  kFlank,               ///< grey values beside the edge differ
  kSteep,               ///< the height changes faster than the largest rate
  kUneven,              ///< the rates of its pieces scatter too much
  kOutOfReach,          ///< no matched line is near
  kHeight,              ///< no candidate is near the height of a matched line
  kLowScore,            ///< it does not resemble its best candidate
  kAmbiguous,           ///< a rival is about as good; see Acquisition::choose()
  kLostToOther,         ///< its candidate belongs to another left segment
};
const char* name(ChioOutcome outcome);  ///< "matched", "epipolar_degenerate", ...

/// A right segment that passes the initial screening, or is long enough to be linked to one.
struct CoreCandidate {
  int right = 0;
  EpipolarOverlap overlap;
  ChainSummary chain;
  double similarity = 0.0;  ///< similarity of the appearance
  bool may_begin = false;   ///< whether it passes the screening and may be the initial link
};

/// The candidates of one left segment.
struct CoreCandidates {
  std::vector<CoreCandidate> list;  ///< by preference; candidates that may not begin come last
  ChioOutcome reason = ChioOutcome::kNoCandidate;  ///< why no candidate may begin, if none may
  double gsd_m = 0.0;  ///< size of a pixel on the ground, at the left segment
};

/// The candidates of every left segment, screened by Core (Chio and Wang 2000; the thresholds of
/// section 4). The screening tests the difference of azimuths, the difference of the grey values
/// beside the edge, the number of reliable pieces, the mean rate of height change and the standard
/// deviation of the rates. The epipolar band is searched by match_candidates(). Candidates with the
/// most reliable pieces are preferred, then those with the steadiest rate. If the appearance
/// decides (ChioExtensions), the most similar candidates are preferred.
std::vector<CoreCandidates> core_candidates(const SearchedPair& pair,
                                            const ChioOptions& options,
                                            const CandidateOptions& candidate_options,
                                            const ChioExtensions& beyond = {});

/// The further fragments of a right edge, as ascending indices into the list. `begin` is the index
/// of the initial link. A further fragment has enough reliable pieces and the rate and azimuth of
/// the initial link in object space, and lies on one line with it in the image.
std::vector<int> linked_fragments(const CoreCandidates& candidates,
                                  int begin,
                                  const View& right,
                                  const ChioOptions& options,
                                  const ChioExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
