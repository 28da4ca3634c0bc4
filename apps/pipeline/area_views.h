// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::apps {

/// An area and the range of heights searched.
struct SearchedPlace {
  std::vector<Eigen::Vector2d> area_m;  ///< see io::ProjectFile
  std::array<double, 2> height_range_m{};
};

/// The images that show the area best, at most `max_views`, the base image first; see
/// reconstruct::choose_views(). Frames whose camera does not specify the image size are opened.
std::vector<io::PatchImage> best_images(const std::vector<io::PatchImage>& images,
                                        std::size_t max_views,
                                        const SearchedPlace& place);

/// Those images that show at least a tenth of the area, among those whose cameras specify the image
/// size.
std::vector<io::PatchImage> images_that_show(const SearchedPlace& place,
                                             const std::vector<io::PatchImage>& images);

/// The part of an image that shows the area at all heights, with a margin of 32 px, in pixels of
/// the part currently read; std::nullopt if it shows less than 2 x 2 pixels of the area. `size_px`:
/// size of the part currently read.
std::optional<io::Window> window_of_area(const SearchedPlace& place,
                                         const io::PatchImage& image,
                                         const Eigen::Vector2i& size_px);

}  // namespace ridgeline::apps
