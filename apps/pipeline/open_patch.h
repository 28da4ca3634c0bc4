// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <functional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Reads a patch file and resolves everything that it leaves open (decide_patch()); ambiguities of
/// its orientation are resolved from the images. Image files may be missing. `assume_crs`: if
/// known, replaces the patch's CRS. Throws IoError under the same conditions as io::read_patch()
/// and decide_patch().
io::Patch read_patch(const std::string& path, const io::Crs& assume_crs = {});

/// Options for patches that are not in their files.
struct PatchLimits {
  double max_image_mpx = 0.0;  ///< see check_patch()
  io::Crs assume_crs{};        ///< see read_patch()
};

/// A patch that can be reconstructed: read_patch(), then check_patch(). `before_check` is called in
/// between, so that it can report the decisions even if a check fails. Throws IoError.
io::Patch open_patch(const std::string& path,
                     const PatchLimits& limits = {},
                     const std::function<void(const io::Patch&)>& before_check = {});

/// The decisions and warnings from reading the patch, each as a self-contained text.
std::vector<std::string> notes_on(const io::Patch& patch);

}  // namespace ridgeline::apps
