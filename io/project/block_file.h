// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// A block of oriented frames, which is reconstructed patch by patch.
struct BlockFile {
  /// All frames, and what every patch of the block shares. The id is the name of the block; heights
  /// and images of the patches are still to be decided, and the area may be empty: then all that
  /// two frames show.
  PatchFile patch;
  double patch_size_m = 100.0;  ///< side of the squares that the block is cut into
  double overlap_m = 20.0;      ///< by which a patch reaches beyond its square on all sides
};

/// Reads a block file (YAML or JSON). Its keys are those of a patch file with images by a folder or
/// patterns, or colmap, but for `block`, its name, in place of `id`; and patch_size_m, overlap_m.
/// See read_patch(). Throws IoError as read_patch() does, and for an overlap of more than half a
/// patch.
BlockFile read_block_file(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
