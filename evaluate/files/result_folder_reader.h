// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/result_folder.h"
#include "evaluate/tables/summary_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::results {

/// The content of run.json; an empty object if there is none. Throws IoError for a file that is no
/// JSON object.
evaluate::Json read_run_json(const std::filesystem::path& folder);

/// Whether the run of this run.json judged given line files: `evaluate`, `pool`.
bool is_of_line_files(const evaluate::Json& run);

/// Whether `joint` adjusts lines to the plane faces beside them, by the options in run.json;
/// nothing if these do not tell, as after `evaluate`.
std::optional<bool> joint_adjusts_to_faces(const evaluate::Json& run);

/// The content of table1.json; without rows if the run did not match. In a folder that `evaluate`
/// wrote (`of_files`) the file is of an earlier run and does not count. Throws IoError for a file
/// that is no Table 1.
evaluate::Table1 read_matching(const std::filesystem::path& folder, bool of_files);

/// The results that the last `evaluate`, `run` or `demo` wrote into a folder: read_evaluations(),
/// read_matching(), and from run.json the inputs' hashes, the time and joint_adjusts_to_faces().
/// Throws IoError for a folder that does not exist or holds no evaluation, and for a file that is
/// gone or not what it should be.
evaluate::ResultFolder read_result_folder(const std::string& folder);

}  // namespace ridgeline::results
