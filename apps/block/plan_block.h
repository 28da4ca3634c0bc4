// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "io/project/block_file.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Like io::read_block_file(), but ambiguities of an orientation are resolved from the frames.
/// Throws IoError under the same conditions.
io::BlockFile read_block(const std::string& path);

/// The files of a block except its frames, the block file first; patterns are expanded, and sidecar
/// files of a surface model are included.
std::vector<FileState> planned_inputs(const io::BlockFile& block);

/// The key of a plan: derived from the cameras and poses of all frames, the area, the heights or
/// the files from which they are derived, and the sizes. Frames are included by path only; each
/// task checks its own frames. `max_image_mpx`: of the tasks; 0: no limit.
std::string key_of_plan(const io::BlockFile& block,
                        const std::vector<FileState>& inputs,
                        double max_image_mpx = 0.0);

/// Divides a block into patches. Their squares lie at multiples of the patch size and cover the
/// area; without an area, the extent of the LIDAR if the heights come from it, else the ground
/// shown in the images.
///   images    those that show each patch best (best_images()); a square shown in fewer than two
///             images has no patch
///   heights   as stated, or from the LIDAR or the surface model around the patch, with the margin
///             of decide_patch()
///   windows   decided by the task, using the same rule
///   radiometry of whole frames, so that a patch looks the same regardless of its size
/// Hashes and radiometry of the frames are computed in parallel; the result does not depend on the
/// number of threads. Throws IoError if no square has two images, and for files that cannot be
/// read.
BlockPlan plan_block(const io::BlockFile& block, double max_image_mpx);

/// A patch of the plan: its frames with their radiometry, area and heights; the windows are left to
/// decide_patch(). `block`: the block of the plan.
io::PatchFile patch_of(const io::BlockFile& block,
                       const BlockPlan& plan,
                       const PlannedPatch& planned);

}  // namespace ridgeline::apps
