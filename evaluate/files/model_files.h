// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/files/output_folder.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// The value of a column in a row; empty text if the row has none.
std::string value_in(const io::AttributeTable& table, std::size_t row, const std::string& name);

/// "buildings.csv", "faces.csv", "kinds.csv" and "buildings_by.csv".
std::vector<std::string> model_names();

/// The tables as CSV; empty if no line file is a model.
struct ModelTables {
  std::string buildings, faces, kinds;
  /// Buildings and lines by the values of JudgeFilesOptions::by; empty without.
  std::string by;
};
/// The tables of those line files that are models: buildings.csv and faces.csv by method, and
/// kinds.csv, how often edges that the model's faces make a kind are of each kind by the planes in
/// the scan. `by`: buildings_by.csv, see JudgeFilesOptions::by.
ModelTables model_tables(const JudgedFiles& judged, const std::vector<std::string>& by);

/// Rows of buildings_by.csv.
/// @param values  of the attribute `column`, one for each building
std::string by_rows(const std::string& method,
                    const std::string& column,
                    const std::vector<evaluate::BuildingRow>& rows,
                    const std::vector<std::string>& values);

/// Tables of which there are only rows; empty without buildings.
ModelTables with_headers(ModelTables rows);

/// Writes the tables, and removes those of an earlier run that are empty now.
void write_models(const ModelTables& tables, const OutputFolder& out);

/// One line for each model that says how many buildings are right and what is wrong with the
/// others.
std::vector<std::string> model_messages(const JudgedFiles& judged);

}  // namespace ridgeline::results
