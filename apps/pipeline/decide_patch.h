// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

namespace ridgeline::apps {

/// Decides what a patch file leaves open, and says so in Patch::decisions:
///   heights `auto`: the lowest and the highest of the LIDAR points, or cells of the surface model,
///     of the area (without an area: of the places that two images or more show), 10 m more on both
///     sides. Heights that hold fewer than a thousandth of the points and are more than 10 m from
///     all others are taken for birds and errors of the scanner;
///   images of a folder, pattern or COLMAP model: those that show the area best
///     (reconstruct::choose_views());
///   what is read of each image: the window that shows the area at all heights, 32 px more on all
///     sides;
///   turns: pixels are read as stored; if that does not fit the size of the camera but the turn
///     that the file states does, they are turned;
///   frame: reconstruct::local_frame() of the base image; around its first pixel if nothing tells
///     its size.
/// Warns of images that show the area but have no file.
/// Throws IoError if no point or fewer than two images show the area, if an image that is listed
/// does not, and for files that cannot be read. An image file that is missing is passed over if
/// nothing has to be known of it.
io::Patch decide_patch(const io::PatchFile& file);

}  // namespace ridgeline::apps
