// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/output_folder.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Checks that none of these files stands in the folder, unless an earlier scene wrote it and it has not changed since. Any
/// other file is somebody's. Throws IoError that names the file.
void check_scene_files(const results::OutputFolder& out, const std::vector<std::string>& names);

/// Records what was written, for the next check, as `simulate.json`: {"files": {NAME: SHA-256}}.
void record_scene_files(const results::OutputFolder& out, const std::vector<std::string>& names);

}  // namespace ridgeline::apps
