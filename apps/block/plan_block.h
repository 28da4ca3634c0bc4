// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "io/project/block_file.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// io::read_block_file(); what an orientation leaves open is decided by the frames. Throws IoError
/// as it does.
io::BlockFile read_block(const std::string& path);

/// The files that a block is made of but its frames, the block file first; patterns are expanded,
/// and files beside a surface model are listed, too.
std::vector<FileState> planned_inputs(const io::BlockFile& block);

/// The key of a plan: of the cameras and poses of all frames, the area, the heights, or the files
/// that they are taken from, and the sizes. Frames count by their paths; each task checks its own.
/// `max_image_mpx`: of the tasks; 0: no limit.
std::string key_of_plan(const io::BlockFile& block,
                        const std::vector<FileState>& inputs,
                        double max_image_mpx = 0.0);

/// Cuts a block into patches. Their squares lie at multiples of the size of a patch and cover the
/// area; without an area the places that the images show, or where the LIDAR lies if the heights
/// come from it.
///   images    of each patch those that show it best (best_images()); a square that fewer than two
///             images show has no patch
///   heights   as stated, or of the LIDAR or the surface model around the patch, with the margin of
///             decide_patch()
///   windows   decided by the task, by the same rule
///   radiometry of whole frames, so that a patch looks the same whatever its size
/// Frames are hashed and their radiometry is taken in parallel; the result does not depend on the
/// number of threads. Throws IoError if no square has two images, and for files that cannot be
/// read.
BlockPlan plan_block(const io::BlockFile& block, double max_image_mpx);

/// The patch of a plan: its frames with their radiometry, area and heights; windows are still to be
/// decided by decide_patch(). `block`: of the plan.
io::PatchFile patch_of(const io::BlockFile& block,
                       const BlockPlan& plan,
                       const PlannedPatch& planned);

}  // namespace ridgeline::apps
