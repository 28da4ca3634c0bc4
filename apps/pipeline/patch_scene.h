// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/scene/scene.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The first two images of a patch are its base pair, which is shown in Table 1 and in the PNG
/// figures of the report.
inline constexpr ViewPair kPairOfPatch{0, 1};

/// The pixels read from an image of a patch.
struct PatchPicture {
  /// Normalised by the radiometry stated in the patch, else by that of the whole file.
  cv::Mat image;
  cv::Mat is_valid;  ///< reconstruct::View::is_valid
};
/// `max_mpx`: argument of io::read_picture().
PatchPicture read_image(const io::PatchImage& image, double max_mpx = 0.0);

/// The images of the patch, read in parallel. If several cannot be read, the error names the first.
std::vector<PatchPicture> patch_images(const io::Patch& patch, double max_mpx = 0.0);

/// The view of an image in a frame, without pixels and segments. `image` must outlive it.
reconstruct::View view_of(const io::PatchImage& image, const LocalFrame& frame);

/// The views of a patch in its frame, without segments; with pixels and View::own_segments if
/// `images` are given. The patch must outlive the scene. Throws IoError like
/// io::read_own_segments().
reconstruct::Scene patch_scene(const io::Patch& patch,
                               const std::vector<PatchPicture>& images = {});

/// Warnings about the images of a scene whose segments were extracted: black_border(), and unused
/// segments of another detector, whose midpoint lies outside the window that is read or which
/// completed_own_segments() leaves out.
std::vector<std::string> image_warnings(const io::Patch& patch, const reconstruct::Scene& scene);

/// The names of the segment files of an image in the folder of a run: edges_file() contains the
/// extracted segments, segments_file() also those found during matching.
std::string edges_file(const io::PatchImage& image);
std::string segments_file(const io::PatchImage& image);

/// The stage that writes the matches.
inline constexpr const char* kMatchStage = "match";

/// The file with the points of the surface in a patch's folder, and the stage that writes it.
inline constexpr const char* kSurfaceFile = "surface.las";
inline constexpr const char* kSurfaceStage = "surface";

/// Maximum number of surface points that a run keeps. A point takes 8 bytes in the report.
inline constexpr std::size_t kMaxSurfacePoints = 150000;

}  // namespace ridgeline::apps
