// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <cstddef>
#include <filesystem>

namespace ridgeline::apps {

/// Merges the lines of the finished tasks, judges the merged lines once against all of the LIDAR,
/// and writes to the folder
///   lines.METHOD.{geojson,gpkg}   the lines of the block
///   evaluation.METHOD.json, judged.METHOD.gpkg, table2.*, ...
///                  as written by `ridgeline evaluate`; each table has a row for the block and one
///                  for every patch
///   patches.csv    the outcome of each patch
///   run.json, report.html
/// Reports which patches have no lines, and why.
/// @return the number of patches without lines
std::size_t merge_block(const io::BlockFile& block,
                        const BlockPlan& plan,
                        const RunOptions& options,
                        const std::filesystem::path& folder);

}  // namespace ridgeline::apps
