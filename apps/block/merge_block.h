// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <cstddef>
#include <filesystem>

namespace ridgeline::apps {

/// Merges what the finished tasks found, judges the merged lines once against all of the LIDAR, and
/// writes into the folder
///   lines.METHOD.{geojson,gpkg}   the lines of the block
///   evaluation.METHOD.json, judged.METHOD.gpkg, table2.*, ...
///                  as `ridgeline evaluate` writes them; a row of each table for the block, and one
///                  for every patch
///   patches.csv    what became of each patch
///   run.json, report.html
/// Says which patches have no lines, and why.
/// @return the number of patches without lines
std::size_t merge_block(const io::BlockFile& block,
                        const BlockPlan& plan,
                        const RunOptions& options,
                        const std::filesystem::path& folder);

}  // namespace ridgeline::apps
