// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/result_folder.h"
#include "evaluate/tables/summary_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::results {

/// run.json; an empty object if there is none. Throws IoError for a file that is no JSON object.
evaluate::Json read_run_json(const std::filesystem::path& folder);

/// Whether `joint` adjusts lines to the plane faces beside them, by the options in run.json; nothing where these do not
/// tell, as those of an evaluation of files.
std::optional<bool> joint_adjusts_to_faces(const evaluate::Json& run);

/// table1.json; without rows if the run did not match. In the folder of an evaluation of files (`of_files`) it is an
/// earlier run's and does not count. Throws IoError for a file that is no Table 1.
evaluate::Table1 read_matching(const std::filesystem::path& folder, bool of_files);

/// What the last `evaluate`, `run` or `demo` wrote: the above, read_evaluations(), and of run.json the inputs' hashes,
/// the time and joint_adjusts_to_faces(). Throws IoError for a folder that does not exist or holds no evaluation, or a file that is gone or not
/// what it should be.
evaluate::ResultFolder read_result_folder(const std::string& folder);

}  // namespace ridgeline::results
