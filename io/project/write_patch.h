// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// What a patch file states and PatchFile does not hold.
struct PatchKeys {
  std::string orientation{};  ///< takes the place of the matrices of the images; empty: none
  std::string cameras{};      ///< beside `orientation`; empty: none
  std::string matrix{};       ///< beside `orientation`; empty: none
};

/// Writes a patch file that read_patch() takes back without loss; paths are written as they stand
/// in `patch`. Whole or not at all. Images have their interior and exterior orientations if they
/// state these, with window_px, else their matrices; with `orientation` nothing but their paths.
/// Throws IoError if the file cannot be written, std::invalid_argument for a patch without heights,
/// an area that is no upright rectangle, and an image with an interior orientation that has no size
/// or no exterior one.
void write_patch(const std::string& path, const PatchFile& patch, const PatchKeys& keys = {});

}  // namespace ridgeline::io
