// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/conventions.h"
#include "io/orientation/orientation.h"
#include "io/project/patch.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The file of an image in a folder: its name is the last part of the image name, possibly with an
/// image extension added.
std::optional<std::string> image_file_in(const std::string& folder, const io::OrientedImage& image);

/// Tie points in the image files of an orientation, found only by their appearance in at most four
/// pairs of images near each other. `files`: by image number. Observations are in pixels of the
/// cameras; files whose size differs from the camera's are scaled if they have the same aspect
/// ratio, and large ones are reduced to 16 million pixels. Pairs are skipped if a file is missing,
/// unreadable, too large or has another aspect ratio.
std::vector<io::PointObservation> find_points_in_files(const io::Orientation& orientation,
                                                       const io::ImageFiles& files);
/// The same, for the files that image_file_in() finds in a folder.
std::vector<io::PointObservation> find_image_points(const io::Orientation& orientation,
                                                    const std::string& folder);

}  // namespace ridgeline::apps
