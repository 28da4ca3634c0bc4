// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// Writes a patch file that read_patch() takes back without loss; paths are written as they stand
/// in `patch`. Whole or not at all. The interior orientation is not written: the matrices say all
/// of images without distortion. Throws IoError if the file cannot be written,
/// std::invalid_argument for an image with an interior orientation.
void write_patch(const std::string& path, const PatchFile& patch);

}  // namespace ridgeline::io
