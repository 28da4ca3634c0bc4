// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/patch.h"
#include "io/results/run_record.h"
#include "reconstruct/reconstruct.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::apps {

/// What can be told of a patch before any work: its images exist, are not too large, fit the size of their cameras and have the
/// same number of bands; the cameras look at the heights to be searched. Throws IoError.
void check_patch(const io::PatchFile& patch);

/// Throws IoError if the plan of a reference system, the patch's own or that of its cloud, is not true to scale beneath
/// the first camera: cameras of central projection see no other. One in which the place has no scale is for the
/// judge to warn of.
void check_scale(const io::PatchFile& patch, const io::Crs& crs);

/// The files that a patch is made of, its own first; patterns expanded. Throws IoError for a pattern
/// that matches none.
std::vector<results::InputFile> input_files(const io::PatchFile& patch);

/// Local frame of the patch: the point that the middle of the base image shows at the mean height,
/// rounded to 100 m.
LocalFrame patch_frame(const io::PatchFile& patch);

/// The first (base) or second image of the patch, normalised.
cv::Mat patch_image(const io::PatchFile& patch, std::size_t i);

/// Those of the first two, read at once. Of two that cannot be read the error names the first.
std::array<cv::Mat, 2> patch_images(const io::PatchFile& patch);

/// Its segments, without the distortion of its lens.
std::vector<EdgeSegment> extract_patch_image(const io::PatchFile& patch,
                                             std::size_t i,
                                             const cv::Mat& image,
                                             const reconstruct::ExtractionOptions& options);

/// The pair of a patch with its segments, ready to be matched. The patch must outlive it, as with load_pair().
reconstruct::StereoPair stereo_pair(const io::PatchFile& patch,
                                    const std::array<cv::Mat, 2>& images,
                                    const std::array<std::vector<EdgeSegment>, 2>& segments);

/// The first two images of a patch, normalised, with their cameras, for reconstruct(). The patch must outlive them.
std::vector<reconstruct::View> patch_views(const io::PatchFile& patch,
                                           const std::array<cv::Mat, 2>& images);

/// check_patch(), then images, check_pair(), cameras and segments of the pair. Throws IoError.
reconstruct::StereoPair load_pair(const io::PatchFile& patch,
                                  const reconstruct::ExtractionOptions& options,
                                  double max_y_parallax_px);

}  // namespace ridgeline::apps
