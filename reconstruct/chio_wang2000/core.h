// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/edge_chain.h"
#include "reconstruct/chio_wang2000/extensions.h"
#include "reconstruct/chio_wang2000/options.h"
#include "reconstruct/views/candidates.h"
#include "reconstruct/views/epipolar_overlap.h"
#include "reconstruct/views/scene.h"

#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {

/// What became of a left segment; of the reasons that its candidates fail for, the last one in this
/// order.
enum class ChioOutcome : std::uint8_t {
  kMatched,
  kNoCandidate,         ///< no right segment in its epipolar band
  kEpipolarDegenerate,  ///< it runs along the epipolar line
  kFewPieces,           ///< too few reliable edge pieces
  kAzimuth,             ///< directions differ
  kFlank,               ///< grey values beside the edge differ
  kSteep,               ///< the height changes at more than the largest rate
  kUneven,              ///< the rates of its pieces scatter
  kOutOfReach,          ///< no matched line is near
  kHeight,              ///< no candidate is near the height of a matched line
  kLowScore,            ///< it does not look like its best candidate
  kAmbiguous,           ///< two candidates are about as good
  kLostToOther,         ///< its candidate belongs to another left segment
};
const char* name(ChioOutcome outcome);  ///< "matched", "epipolar_degenerate", ...

/// A right segment that passes the initial screening, or is long enough to be linked to one.
struct CoreCandidate {
  int right = 0;
  EpipolarOverlap overlap;
  ChainSummary chain;
  double similarity = 0.0;  ///< of the look
  bool may_begin = false;   ///< passes the screening: may be the initial link
};

/// The candidates of one left segment.
struct CoreCandidates {
  std::vector<CoreCandidate> list;                 ///< by preference; those that may not begin last
  ChioOutcome reason = ChioOutcome::kNoCandidate;  ///< why none may begin, if so
  double gsd_m = 0.0;                              ///< of its pixels
};

/// The candidates of every left segment that pass the screening of Core (Chio and Wang 2000; the
/// thresholds of section 4): difference of azimuths, of the grey values beside the edge, number of
/// reliable pieces, mean rate of height change and its standard deviation. The epipolar band is
/// searched as match_candidates() does. Preference: the most reliable pieces, then the steadiest rate;
/// or the look (ChioExtensions).
std::vector<CoreCandidates> core_candidates(const SearchedPair& pair,
                                            const ChioOptions& options,
                                            const CandidateOptions& candidate_options,
                                            const ChioExtensions& beyond = {});

/// Further fragments of the right edge that `begin`, an index of the list, is one of: enough reliable
/// pieces, the same rate and azimuth in object space, on one line in the image. Indices, ascending.
std::vector<int> linked_fragments(const CoreCandidates& candidates,
                                  int begin,
                                  const View& right,
                                  const ChioOptions& options,
                                  const ChioExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
