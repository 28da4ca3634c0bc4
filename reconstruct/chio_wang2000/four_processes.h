// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/acquisition.h"
#include "reconstruct/chio_wang2000/core.h"
#include "reconstruct/chio_wang2000/extensions.h"
#include "reconstruct/chio_wang2000/options.h"
#include "reconstruct/views/epipolar_transfer.h"
#include "reconstruct/views/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

struct ProcessedSegments {
  std::vector<std::optional<Acquired>> acquired;  ///< by left segment
  std::vector<ChioOutcome> outcomes;
};

/// The four processes of Chio and Wang 2000, section 3. From the strongest structure to the weakest:
///   1  if a junction of the right image corresponds to that of the structure, on its epipolar line
///      and with segments for at least two of its members, Core matches the strongest member;
///   2  its height constrains Core on the other members.
/// Then, with the height limit of 0.5 m and again with that of 5 m:
///   3  members of structures with a matched member, constrained by its height, until nothing
///      changes;
///   4  segments within range of matched ones, constrained by their height, until nothing changes.
/// 3 and 4 repeat until neither finds more. The geometric constraint becomes looser from process to
/// process, those of Core never change. NeighbourHeights compares the heights.
///
/// Matches of another matcher may stand in place of the first two processes, `given`; then what 3 and
/// 4 find beside them by the close limit is all.
ProcessedSegments four_processes(const SearchedPair& pair,
                                 const std::vector<CoreCandidates>& candidates,
                                 const ChioOptions& options,
                                 const ChioExtensions& beyond = {},
                                 std::span<const ScoredMatch> given = {});

}  // namespace ridgeline::reconstruct
