// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/result_folder.h"

#include <string>

namespace ridgeline::results {

/// Reads what the last `evaluate`, `run` or `demo` wrote: the evaluations that EvaluatedMethods finds in
/// the folder and its subfolders (one per patch), and run.json for the inputs' hashes and the time.
/// Throws IoError for a folder that does not exist or holds no evaluation, or a file that is gone or
/// not what it should be.
evaluate::ResultFolder read_result_folder(const std::string& folder);

}  // namespace ridgeline::results
