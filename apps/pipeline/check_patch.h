// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/run_record.h"
#include "io/project/block_file.h"
#include "io/project/patch.h"

#include <vector>

namespace ridgeline::apps {

/// Checks everything about a patch that can be checked before the work begins: its images exist,
/// are not larger than `max_image_mpx` (see io::check_image_size()), fit the size of their cameras
/// and have the same number of bands, and the cameras see the heights to be searched. Reads the
/// headers of images that have not been read yet. Throws IoError.
void check_patch(const io::Patch& patch, double max_image_mpx);

/// Compares the projection centres with the area of use of the project's CRS: adds a warning if
/// they lie outside, and throws IoError if they lie far outside; see io::check_area_of_use().
void check_positions(io::Project& project);

/// Throws IoError if the plan of a reference system (the patch's own or that of its cloud) is not
/// true to scale beneath the first camera, as central projection requires. A place without a scale
/// in the reference system passes; the judge warns about it.
void check_scale(const io::Patch& patch, const io::Crs& crs);

/// The input files of a patch or block, starting with its own file; patterns are expanded. Throws
/// IoError for a pattern that matches no file.
std::vector<results::InputFile> input_files(const io::Patch& patch);
std::vector<results::InputFile> input_files(const io::BlockFile& block);

}  // namespace ridgeline::apps
