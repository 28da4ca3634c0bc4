// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/result_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// evaluation.*.json of the folder and of its subfolders, sorted.
std::vector<std::filesystem::path> evaluation_files(const std::filesystem::path& folder);

/// Reads what `evaluate`, `run` or `demo` wrote: evaluation.*.json of the folder and of its
/// subfolders (one per patch), and run.json for the inputs' hashes and the time.
/// Throws IoError for a folder that does not exist or holds no evaluation, or a file that is not
/// what it should be.
evaluate::ResultFolder read_result_folder(const std::string& folder);

}  // namespace ridgeline::apps
