// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Reads a JSON object. Throws IoError if the file does not contain one.
evaluate::Json read_json_object(const std::filesystem::path& file);

/// An evaluation.METHOD.json in a results folder.
struct FoundEvaluation {
  std::filesystem::path path;
  std::string subfolder;  ///< "", or "PATCH/" if written by `run`
  evaluate::Evaluation evaluation;
  std::size_t rank = 0;  ///< place in table2.json; 0 without that file
};

/// The evaluations that the last run wrote to a folder, ordered by path. Evaluations that are not
/// listed in its table2.json come from earlier runs and are ignored, even if damaged; without that
/// table, none is ignored. `is_flat`: whether `evaluate` or `block` wrote the folder, without a
/// subfolder per patch. Throws IoError for an invalid file, for a listed evaluation that is
/// missing, and for a folder without evaluations.
std::vector<FoundEvaluation> read_evaluations(const std::filesystem::path& folder, bool is_flat);

}  // namespace ridgeline::results
