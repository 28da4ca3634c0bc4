// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_files.h"
#include "io/results/output_folder.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// "buildings.csv", "faces.csv", "kinds.csv" and "buildings_by.csv".
std::vector<std::string> model_names();

/// The tables as CSV; empty if no line file is a model.
struct ModelTables {
  std::string buildings, faces, kinds;
  /// Buildings and lines by the values of JudgeFilesOptions::by; empty without.
  std::string by;
};
ModelTables model_tables(const JudgedFiles& judged, const std::vector<std::string>& by);

/// Writes the tables of those line files that are models: buildings.csv and faces.csv by method,
/// and kinds.csv, how often edges that the model's faces make a kind are of each kind by the planes
/// in the scan. `by`: buildings_by.csv, see JudgeFilesOptions::by. Without a model it removes what
/// an earlier run has left.
void write_models(const JudgedFiles& judged,
                  const std::vector<std::string>& by,
                  const OutputFolder& out);

/// One line for each model that says how many buildings are right and what is wrong with the
/// others.
std::vector<std::string> model_messages(const JudgedFiles& judged);

}  // namespace ridgeline::results
