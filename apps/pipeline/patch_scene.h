// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/views/scene.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace ridgeline::apps {

/// Lines are reconstructed from the first two images of a patch.
inline constexpr reconstruct::ViewPair kPairOfPatch{0, 1};

/// The first (base) or second image of the patch, normalised.
cv::Mat patch_image(const io::PatchFile& patch, std::size_t i);

/// Those of the first two, read at once. Of two that cannot be read the error names the first.
std::array<cv::Mat, 2> patch_images(const io::PatchFile& patch);

/// The first two views of a patch in a frame, without images and segments. The patch must outlive it.
reconstruct::Scene patch_scene(const io::PatchFile& patch, const LocalFrame& frame);

/// The same with images that fit their cameras: check_pair(), whose doubt is printed. Throws IoError.
reconstruct::Scene load_scene(const io::PatchFile& patch,
                              const LocalFrame& frame,
                              double max_y_parallax_px);

/// Where the segments of an image stand in a folder of files of stages; those that were extracted, and those together with
/// the ones found while matching.
std::string edges_file(const io::PatchImage& image);
std::string segments_file(const io::PatchImage& image);

}  // namespace ridgeline::apps
