// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <optional>
#include <vector>

namespace ridgeline::apps {

/// The images of a patch with an area that show it best, the base image first; see
/// reconstruct::choose_views(). Frames whose camera states no size are opened.
std::vector<io::PatchImage> best_images(const io::PatchFile& patch);

/// Those of PatchFile::without_file that show at least a tenth of the area.
std::vector<io::PatchImage> images_without_file(const io::PatchFile& patch);

/// The part of an image that shows the area of the patch at all of its heights, with a margin of 32
/// px, in pixels of what is read now; nothing if it shows none of it or less than 2 x 2 pixels.
/// `size_px`: of what is read now.
std::optional<io::Window> window_of_area(const io::PatchFile& patch,
                                         const io::PatchImage& image,
                                         const Eigen::Vector2i& size_px);

}  // namespace ridgeline::apps
