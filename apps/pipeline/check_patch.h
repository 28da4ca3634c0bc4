// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/run_record.h"
#include "io/project/patch.h"

#include <vector>

namespace ridgeline::apps {

/// A patch that check_patch() found fault-free, with its local frame.
struct CheckedPatch {
  io::PatchFile file;
  LocalFrame frame;
};

/// Checks what can be told of a patch before any work: its images exist, are not too large, fit the
/// size of their cameras and have the same number of bands; the cameras look at the heights to be
/// searched. Reads the headers of the images.
/// @return the local frame of the patch (reconstruct::local_frame())
/// Throws IoError.
LocalFrame check_patch(const io::PatchFile& patch);

/// Throws IoError if the plan of a reference system (the patch's own or that of its cloud) is not
/// true to scale beneath the first camera, as a camera of central projection needs it. A place that
/// has no scale in the reference system passes; the judge warns of it.
void check_scale(const io::PatchFile& patch, const io::Crs& crs);

/// The files that a patch is made of, the patch file first; patterns are expanded. Throws IoError
/// for a pattern that matches no file.
std::vector<results::InputFile> input_files(const io::PatchFile& patch);

}  // namespace ridgeline::apps
