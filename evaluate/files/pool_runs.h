// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/model_files.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <array>
#include <string>
#include <vector>

namespace ridgeline::results {

/// A results folder with the judgement of one area.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct AreaRun {
  std::string folder;
  evaluate::Json run;                             ///< its run.json
  std::array<double, 4> bounds{};                 ///< see evaluate::AreaPart
  std::vector<evaluate::Evaluation> evaluations;  ///< in the order of the line files
};

/// The judgements of several areas, combined into one of all lines.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct PooledRuns {
  std::vector<AreaRun> runs;                      ///< by their bounds; without lines
  std::vector<evaluate::Evaluation> evaluations;  ///< one per line file
  ModelTables models;
  evaluate::Json options;              ///< common to all runs, with the paths of the first
  std::vector<evaluate::Json> inputs;  ///< of all runs, as run.json records them
  std::vector<std::string> warnings;
};

/// Reads the folders of runs that judged the same line files area by area and combines their lines
/// in the order of the files. The figures are recomputed from all lines; planes of several runs
/// that were fitted to the same points become one. Throws IoError for a folder that does not
/// contain the judgement of an area, for runs that differ in lines, options, versions or reference
/// systems, for runs that moved their lines, for overlapping areas, for duplicate lines, and, like
/// judge_files(), for lines that do not fit the cloud.
PooledRuns pool_runs(const std::vector<std::string>& folders);

}  // namespace ridgeline::results
