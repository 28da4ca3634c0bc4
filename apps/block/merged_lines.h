// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/block/block_task.h"
#include "io/lines/line_set.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace ridgeline::apps {

/// Counts of a block's lines by one method.
struct MergedCounts {
  std::size_t n_found = 0;          ///< lines with a position, in all patches
  std::size_t n_without_place = 0;  ///< lines that tasks could not reconstruct
};

/// Merges the lines that finished tasks reconstructed by a method (reconstruct::LineMerger), column
/// by column of the grid, so that only a few columns are in memory. Lines whose midpoint is outside
/// the area of the block are left out. Ids become PATCH/ID, and image segments are in pixels of the
/// whole frames. `tasks`: in the order of the plan. `take` receives each line with the index of its
/// patch in BlockPlan::patches, in the order of the squares. Throws IoError for files that were not
/// written by a task.
MergedCounts merge_lines_of(const BlockPlan& plan,
                            const std::vector<const BlockTask*>& tasks,
                            reconstruct::Method method,
                            const std::function<void(const io::Line&, std::size_t patch)>& take);

}  // namespace ridgeline::apps
