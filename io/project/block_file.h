// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// The content of the file of a block of oriented frames, which is reconstructed patch by patch.
/// The images are all frames, from which those of each patch are chosen. Without an area, the block
/// covers everything that two frames show.
struct BlockFile : ProjectFile {
  double patch_size_m = 100.0;  ///< side of the squares that the block is cut into
  double overlap_m = 20.0;      ///< by which a patch extends beyond its square on all sides; unless
                                ///< stated, at most half of patch_size_m
};

/// Reads a block file (YAML or JSON). Its keys are those of a patch file whose images are given by
/// a folder, patterns or colmap, except that its name is `block` instead of `id`; in addition,
/// patch_size_m and overlap_m. See read_patch(). Throws IoError under the same conditions as
/// read_patch(), and for an overlap of more than half a patch.
BlockFile read_block_file(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
