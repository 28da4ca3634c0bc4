// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/scene/scene.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The first two images of a patch are its base pair, the one that Table 1 and the PNG figures of
/// the report show.
inline constexpr ViewPair kPairOfPatch{0, 1};

/// What is read of an image of a patch.
struct PatchPicture {
  cv::Mat image;     ///< normalised, by the radiometry that the patch states, else by that of the
                     ///< whole file
  cv::Mat is_valid;  ///< reconstruct::View::is_valid
};
/// `max_mpx`: argument of io::read_picture().
PatchPicture read_image(const io::PatchImage& image, double max_mpx = 0.0);

/// The images of the patch, read in parallel. If several cannot be read, the error names the first.
std::vector<PatchPicture> patch_images(const io::Patch& patch, double max_mpx = 0.0);

/// The view of an image in a frame, without image and segments. `image` must outlive it.
reconstruct::View view_of(const io::PatchImage& image, const LocalFrame& frame);

/// The views of a patch in its frame, without segments; if `images` are given, with these and
/// View::own_segments. The patch must outlive it. Throws IoError as io::read_own_segments().
reconstruct::Scene patch_scene(const io::Patch& patch,
                               const std::vector<PatchPicture>& images = {});

/// Warns of segments of another detector that are not used: their middle lies outside of the window
/// that is read, or completed_own_segments() leaves them out.
std::vector<std::string> unused_segments(const io::Patch& patch, const reconstruct::Scene& scene);

/// The names that the files of an image's segments have in the folder of a run: edges_file() holds
/// the extracted segments, segments_file() these and the ones found while matching.
std::string edges_file(const io::PatchImage& image);
std::string segments_file(const io::PatchImage& image);

/// The stage that writes the matches.
inline constexpr const char* kMatchStage = "match";

/// The file in a patch's folder that holds the points of the surface, and the stage that writes it.
inline constexpr const char* kSurfaceFile = "surface.las";
inline constexpr const char* kSurfaceStage = "surface";

/// Most points of a surface that a run keeps. A point takes 8 bytes of the report.
inline constexpr std::size_t kMaxSurfacePoints = 150000;

}  // namespace ridgeline::apps
