// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/conventions.h"
#include "io/orientation/orientation.h"
#include "io/project/patch.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The file of an image in a folder: the one with the last part of its name, or with that and an
/// extension of images.
std::optional<std::string> image_file_in(const std::string& folder, const io::OrientedImage& image);

/// Points that neighbouring images of an orientation both show, found by their appearance alone in
/// the files of the images, by number: in at most four pairs of images near each other.
/// Observations are in pixels of the cameras; files of another size than the camera's, but of its
/// shape, are scaled, and large ones are reduced to 16 million pixels. Pairs whose files are not
/// there or cannot be read, are too large or have another shape, give none.
std::vector<io::PointObservation> find_points_in_files(const io::Orientation& orientation,
                                                       const io::ImageFiles& files);
/// The same in the files that image_file_in() finds in a folder.
std::vector<io::PointObservation> find_image_points(const io::Orientation& orientation,
                                                    const std::string& folder);

}  // namespace ridgeline::apps
