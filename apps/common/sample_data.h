// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace ridgeline::apps {

/// The folders of the sample patches, sorted: from the environment variable RIDGELINE_SAMPLE_DATA,
/// next to the installed program (share/ridgeline/sample_data) or in the source tree from which it
/// was built. If there are none, throws IoError naming the places searched.
std::vector<std::filesystem::path> sample_patches();

}  // namespace ridgeline::apps
