// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::apps {

/// An area at all heights that are searched.
struct SearchedPlace {
  std::vector<Eigen::Vector2d> area_m;  ///< see io::ProjectFile
  std::array<double, 2> height_range_m{};
};

/// The images that show the area best, at most `max_views`, the base image first; see
/// reconstruct::choose_views(). Frames whose camera states no size are opened.
std::vector<io::PatchImage> best_images(const std::vector<io::PatchImage>& images,
                                        std::size_t max_views,
                                        const SearchedPlace& place);

/// The images that show at least a tenth of the area, of those whose cameras state a size.
std::vector<io::PatchImage> images_that_show(const SearchedPlace& place,
                                             const std::vector<io::PatchImage>& images);

/// The part of an image that shows the area at all heights, with a margin of 32
/// px, in pixels of what is read now; nothing if it shows none of it or less than 2 x 2 pixels.
/// `size_px`: of what is read now.
std::optional<io::Window> window_of_area(const SearchedPlace& place,
                                         const io::PatchImage& image,
                                         const Eigen::Vector2i& size_px);

}  // namespace ridgeline::apps
