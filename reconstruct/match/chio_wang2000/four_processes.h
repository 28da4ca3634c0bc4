// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/match/chio_wang2000/acquisition.h"
#include "reconstruct/match/chio_wang2000/core.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/match/chio_wang2000/options.h"
#include "reconstruct/scene/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Limit of the height difference in the third and fourth process once they find nothing more (Chio
/// and Wang 2000, section 4).
inline constexpr double kRelaxedHeightDifference_m = 5.0;

struct ProcessedSegments {
  std::vector<std::optional<Acquired>> acquired;  ///< by left segment
  std::vector<ChioOutcome> outcomes;
};

/// The four processes of Chio and Wang 2000, section 3. Processes 1 and 2 go from the strongest
/// structure to the weakest:
///   1  A junction of the right image corresponds to the junction of the structure if it lies on
///      the epipolar line of the latter and has counterparts of at least two members. Core then
///      matches the strongest member.
///   2  The height of this member constrains Core for the other members.
/// Processes 3 and 4 follow, with the height limit of 0.5 m and again with that of 5 m:
///   3  Members of structures with a matched member are matched, constrained by its height, until
///      nothing changes.
///   4  Segments within range of matched ones are matched, constrained by their height, until
///      nothing changes.
/// Processes 3 and 4 repeat until neither finds more. The geometric constraint becomes looser from
/// process to process; the constraints of Core never change. NeighbourHeights compares the heights.
ProcessedSegments four_processes(const SearchedPair& pair,
                                 const std::vector<CoreCandidates>& candidates,
                                 const ChioOptions& options,
                                 const ChioExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
