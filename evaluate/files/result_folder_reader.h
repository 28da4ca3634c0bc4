// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/result_folder.h"
#include "evaluate/tables/summary_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::results {

/// The content of run.json; an empty object if the file is missing. Throws IoError if it is not a
/// JSON object.
evaluate::Json read_run_json(const std::filesystem::path& folder);

/// Whether this run.json comes from a run that judged given line files (`evaluate`, `pool`).
bool is_of_line_files(const evaluate::Json& run);

/// Whether `joint` adjusts lines to adjacent plane faces, according to the options in run.json;
/// std::nullopt if these do not include it, as after `evaluate`.
std::optional<bool> joint_adjusts_to_faces(const evaluate::Json& run);

/// The content of table1.json; without rows if the run did not match. In a folder written by
/// `evaluate` (`of_files`) the file comes from an earlier run and is ignored. Throws IoError if the
/// file is not a Table 1.
evaluate::Table1 read_matching(const std::filesystem::path& folder, bool of_files);

/// The results that the last `evaluate`, `run` or `demo` wrote to a folder: read_evaluations(),
/// read_matching() and, from run.json, the hashes of the inputs, the run time and
/// joint_adjusts_to_faces(). Throws IoError for a folder that does not exist or contains no
/// evaluation, and for a missing or invalid file.
evaluate::ResultFolder read_result_folder(const std::string& folder);

}  // namespace ridgeline::results
