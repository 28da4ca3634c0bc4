// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// What the file of a block of oriented frames states, which is reconstructed patch by patch. The
/// images are all frames, from which the images of each patch are chosen. Without an area the block
/// is all that two frames show.
struct BlockFile : ProjectFile {
  double patch_size_m = 100.0;  ///< side of the squares that the block is cut into
  double overlap_m = 20.0;      ///< by which a patch reaches beyond its square on all sides
};

/// Reads a block file (YAML or JSON). Its keys are those of a patch file with images by a folder or
/// patterns, or colmap, but for `block`, its name, in place of `id`; and patch_size_m, overlap_m.
/// See read_patch(). Throws IoError as read_patch() does, and for an overlap of more than half a
/// patch.
BlockFile read_block_file(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
