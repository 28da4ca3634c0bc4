// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/files/judged_lines.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Names of the files that judging these line files may write, except the report. They are checked
/// before judging.
std::vector<std::string> result_names(const std::vector<std::string>& line_paths);

/// Names of the files of a method: evaluation.METHOD.json, evaluation.METHOD.csv,
/// accuracy.METHOD.md, judged.METHOD.gpkg.
std::vector<std::string> evaluation_names(const std::string& method);

/// Writes evaluation.METHOD.json, evaluation.METHOD.csv and accuracy.METHOD.md below `subfolder`.
void write_evaluation_files(const evaluate::Evaluation& evaluation,
                            const OutputFolder& out,
                            const std::string& subfolder);

/// Writes evaluation.METHOD.json, evaluation.METHOD.csv (per line), accuracy.METHOD.md (the
/// labelled accuracy figures, the strata and the figures of standards) and the map
/// judged.METHOD.gpkg of each evaluation, below `subfolder` ("" or "PATCH/").
void write_judged(const JudgedFiles& judged,
                  MapSchema schema,
                  const OutputFolder& out,
                  const std::string& subfolder);

/// Writes the points of the planes, coloured by plane as in the report; see
/// io::write_labelled_points().
void write_plane_points(const std::string& path, const JudgedFiles& judged);

/// Writes the tables of all evaluations. `truth`: one entry per evaluation.
/// `joint_adjusts_to_faces`: see Table2.
///   table2.{md,csv,json,tex}, parts.csv
///   table2.common.{md,csv}: Table 2 on the lines evaluated by all methods of a patch except
///     `planes`, if a patch has several such methods
///   tolerances.{csv,md}: precision and completeness at tolerances
///   reference_errors.csv, reference_completeness.csv, wireframe.csv, reference.md: with reference
///     lines
///   quality.{csv,xml}: the measures of ISO 19157
///   decoys.csv: if there are decoys
///   completeness.csv: if the lines were compared with the edges of the scan
void write_tables(std::span<const evaluate::Evaluation> evaluations,
                  const std::vector<TruthRows>& truth,
                  const OutputFolder& out,
                  bool joint_adjusts_to_faces = false);

}  // namespace ridgeline::results
