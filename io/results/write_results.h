// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "io/results/judge_files.h"
#include "io/results/judged_lines.h"
#include "io/results/judged_map.h"
#include "io/results/output_folder.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Names of the files that an evaluation of the line files can write before its report, to be
/// checked before it.
std::vector<std::string> result_names(const std::vector<std::string>& line_paths);

/// evaluation.METHOD.json, evaluation.METHOD.csv, accuracy.METHOD.md, judged.METHOD.gpkg.
std::vector<std::string> evaluation_names(const std::string& method);

/// Writes evaluation.METHOD.json, evaluation.METHOD.csv (per line), accuracy.METHOD.md (the labelled accuracy
/// numbers and the strata) and the map judged.METHOD.gpkg of each evaluation, below `subfolder` ("" or "PATCH/").
void write_judged(const JudgedFiles& judged,
                  MapSchema schema,
                  const OutputFolder& out,
                  const std::string& subfolder);

/// Writes the points of the planes, coloured by plane as in the report; see io::write_labelled_points().
void write_plane_points(const std::string& path, const JudgedFiles& judged);

/// Writes quality.csv and quality.xml: the measures of ISO 19157. `truth`: one for each evaluation.
void write_quality(std::span<const evaluate::Evaluation> evaluations,
                   const std::vector<TruthRows>& truth,
                   const OutputFolder& out);

/// Writes tolerances.{csv,md}: precision and completeness at tolerances; and, where there are
/// reference lines, reference_errors.csv, reference_completeness.csv and reference.md.
void write_truth(const std::vector<TruthRows>& rows, const OutputFolder& out);

/// Writes table2.{md,csv,json,tex} of all evaluations and parts.csv. Where a patch has
/// several methods: also table2.common.{md,csv} on the lines that all of them have evaluated.
void write_table2(std::span<const evaluate::Evaluation> evaluations, const OutputFolder& out);

}  // namespace ridgeline::results
