// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "io/lines/line_set.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// A finished task.
struct FinishedPatch {
  const PlannedPatch* planned = nullptr;
  std::string patch_path;  ///< its patch file
  std::string lines_path;  ///< its lines of one method
};

/// The lines of a block by one method.
struct BlockLines {
  io::LineSet set;
  std::vector<std::size_t> patch_of_line;  ///< number in BlockPlan::patches
  std::size_t n_found = 0;                 ///< lines with a place, of all patches
  std::size_t n_without_place = 0;         ///< lines that tasks could not reconstruct
};

/// Merges the lines of finished tasks (reconstruct::merge_lines()) and leaves out those whose midpoint is outside of the
/// area of the block. Ids become PATCH/ID, and image segments are in pixels of the whole frames.
/// Throws IoError for files that are none of a task.
BlockLines merged_lines(const BlockPlan& plan, const std::vector<FinishedPatch>& patches);

}  // namespace ridgeline::apps
