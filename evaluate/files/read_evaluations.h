// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Reads a JSON object. Throws IoError for a file that is none.
evaluate::Json read_json_object(const std::filesystem::path& file);

/// An evaluation.METHOD.json of a folder of results.
struct FoundEvaluation {
  std::filesystem::path path;
  std::string subfolder;  ///< "", or "PATCH/" where `run` has written it
  evaluate::Evaluation evaluation;
  std::size_t rank = 0;  ///< place in table2.json; 0 without that file
};

/// The evaluations of the last run into a folder, in the order of their paths. Evaluations that its
/// table2.json does not name are of earlier runs and do not count, even if they are damaged.
/// Without that table all count. `is_flat` says that `evaluate` or `block` wrote the folder: into
/// itself, not into a subfolder for each patch. Throws IoError for a file that is not what it
/// should be, for an evaluation of the table that is missing, and for a folder without evaluations.
std::vector<FoundEvaluation> read_evaluations(const std::filesystem::path& folder, bool is_flat);

}  // namespace ridgeline::results
