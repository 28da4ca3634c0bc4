// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace ridgeline::apps {

/// The folders of the sample patches, sorted: from the environment variable RIDGELINE_SAMPLE_DATA,
/// beside the installed program (share/ridgeline/sample_data) or in the source tree it was built
/// from. Throws IoError naming the places looked at if there are none.
std::vector<std::filesystem::path> sample_patches();

}  // namespace ridgeline::apps
