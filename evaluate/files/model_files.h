// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/files/output_folder.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ridgeline::results {

/// The value of a column in a row; empty text if the row has none.
std::string value_in(const io::AttributeTable& table, std::size_t row, const std::string& name);

/// "buildings.csv", "faces.csv", "kinds.csv", "buildings_by.csv" and "missing_roofs.csv".
std::vector<std::string> model_names();

/// The tables of models as CSV; empty if no line file is a model.
struct ModelTables {
  std::string buildings, faces, kinds;
  /// Buildings and lines by the values of JudgeFilesOptions::by; may be empty.
  std::string by;
  std::string missing_roofs;     ///< empty unless the models were compared with the scan's edges
  bool with_scan_edges = false;  ///< whether they were
};

/// A row of missing_roofs.csv.
struct MissingRoofRow {
  double area_m2 = 0.0, explained = 0.0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< in the cloud's coordinates
};

/// The rows of missing_roofs.csv for one method, the largest roof first.
std::string missing_roof_rows(const std::string& method, std::vector<MissingRoofRow> roofs);

/// The tables of those line files that are models: buildings.csv and faces.csv by method, and
/// kinds.csv, which counts edges by their kind in the model and their kind according to the planes
/// in the scan; missing_roofs.csv if the edges of the scan are known. `by`: the attributes for
/// buildings_by.csv, see JudgeFilesOptions::by.
ModelTables model_tables(const JudgedFiles& judged, const std::vector<std::string>& by);

/// The rows of buildings_by.csv for one attribute.
/// @param values  of the attribute `column`, one per building
std::string by_rows(const std::string& method,
                    const std::string& column,
                    const std::vector<evaluate::BuildingRow>& rows,
                    const std::vector<std::string>& values);

/// Adds headers to tables that only have rows; empty without buildings.
ModelTables with_headers(ModelTables rows);

/// Writes the tables; removes files of an earlier run whose tables are empty in this one.
void write_models(const ModelTables& tables, const OutputFolder& out);

/// One message per model: how many buildings are right and what is wrong with the others.
std::vector<std::string> model_messages(const JudgedFiles& judged);

}  // namespace ridgeline::results
