// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// Keys of a patch file that PatchFile does not contain.
struct PatchKeys {
  std::string orientation{};  ///< replaces the matrices of the images; empty: none
  std::string cameras{};      ///< with `orientation` only; empty: none
  std::string matrix{};       ///< with `orientation` only; empty: none
};

/// Writes a patch file that read_patch() reads back without loss, completely or not at all; paths
/// are written as given in `patch`. Images are written with their interior and exterior orientation
/// and window_px if available, otherwise with their matrices; with `orientation`, only with their
/// paths. Throws IoError if the file cannot be written, std::invalid_argument for a patch without
/// heights, an area that is not an axis-parallel rectangle, and an image with an interior
/// orientation but without its size or an exterior orientation.
void write_patch(const std::string& path, const PatchFile& patch, const PatchKeys& keys = {});

}  // namespace ridgeline::io
