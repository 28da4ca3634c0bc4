// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/run/patch_run.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Runs the patches one after another, writes the tables over all of them and run.json, and prints
/// Table 1 (where there are reference matches) and Table 2. All patch files are read and checked
/// before the first one is run.
void run_patches(const std::string& command,
                 const std::vector<std::string>& patch_files,
                 const RunOptions& options,
                 const std::string& out);

}  // namespace ridgeline::apps
