// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

namespace ridgeline::apps {

/// Resolves what a patch file leaves open and records it in Patch::decisions:
///   heights `auto`: the lowest and highest LIDAR point or surface model cell in the area (without
///     an area: in the places shown by two or more images), with a margin of 10 m. Groups of fewer
///     than a thousandth of the points that are more than 10 m from all others are assumed to be
///     birds or scanner errors;
///   images from a folder, pattern or COLMAP model: those that show the area best
///     (reconstruct::choose_views());
///   part of each image to be read: the window that shows the area at all heights, with a margin of
///     32 px;
///   turns: pixels are read as stored; if these do not fit the size of the camera but would after
///     the turn stated by the file, they are turned;
///   frame: reconstruct::local_frame() of the base image; around its first pixel if its size is
///     unknown.
/// Warns about images that show the area but have no file.
/// Throws IoError if no point lies in the area, if fewer than two images or not all listed images
/// show it, and for files that cannot be read. A missing image file is ignored if no information
/// from it is needed.
io::Patch decide_patch(const io::PatchFile& file);

}  // namespace ridgeline::apps
