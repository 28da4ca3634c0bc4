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

/// The files that a block is made of but its frames, the block file first; patterns are expanded.
std::vector<PlannedFile> planned_inputs(const io::BlockFile& block);

/// The key of a plan: equal for blocks whose frames have the same names, and whose other inputs
/// have the same names, sizes and, where they are known, hashes.
std::string key_of(const io::BlockFile& block, const std::vector<PlannedFile>& inputs);

/// Cuts a block into patches. Their squares lie at multiples of the size of a patch and cover the
/// area; without an area the places that the images show, or where the LIDAR lies if the heights
/// come from it.
///   images    of each patch those that show it best (best_images()); a square that fewer than two
///             images show has no patch
///   heights   as stated, or of the LIDAR or the surface model around the patch, with the margin of
///             complete_patch()
///   windows   decided by the task, by the same rule
///   radiometry of whole frames, so that a patch looks the same whatever its size
/// Frames are hashed and their radiometry is taken in parallel; the result does not depend on the
/// number of threads. Throws IoError if no square has two images, and for files that cannot be
/// read.
BlockPlan plan_block(const io::BlockFile& block);

/// The patch of a plan as a patch file states it, with a window and the radiometry of every image.
/// `block`: of the plan.
io::PatchFile patch_of(const io::BlockFile& block,
                       const BlockPlan& plan,
                       const PlannedPatch& planned);

}  // namespace ridgeline::apps
