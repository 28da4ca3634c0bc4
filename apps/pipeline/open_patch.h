// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <functional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The patch of a file, with all decided that the file leaves open (decide_patch()); what its
/// orientation leaves open is decided by the images. Image files may be missing. `assume_crs`:
/// takes the place of the patch's CRS, if it is known. Throws IoError as io::read_patch() and
/// decide_patch().
io::Patch read_patch(const std::string& path, const io::Crs& assume_crs = {});

/// What the user says of patches beside their files.
struct PatchLimits {
  double max_image_mpx = 0.0;  ///< see check_patch()
  io::Crs assume_crs{};        ///< see read_patch()
};

/// A patch that can be reconstructed: read_patch(), then check_patch(). Between these,
/// `before_check` may say what was decided, so that this is known if a check fails. Throws IoError.
io::Patch open_patch(const std::string& path,
                     const PatchLimits& limits = {},
                     const std::function<void(const io::Patch&)>& before_check = {});

/// What was decided in reading the patch, and its warnings, each in a text that stands alone.
std::vector<std::string> notes_on(const io::Patch& patch);

}  // namespace ridgeline::apps
