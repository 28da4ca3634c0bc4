// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/shared_options.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/run_record.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Output options for the results of a judgement.
struct EvaluationOutput {
  std::string folder;
  std::string schema = "plain";  ///< see results::map_schema_named()
  std::string plane_points;      ///< file for the points of the planes; may be empty
  std::string attributes = {};   ///< file for the model with figures; may be empty
  bool report = true;
  PageFacts page;
};

/// The input files of a judgement. `config`: the parameter file; may be empty.
std::vector<results::InputFile> inputs_of(const results::JudgeFilesOptions& options,
                                          const std::string& config);

/// Writes all files of a judgement, including run.json and the report, and prints the outcome.
/// Throws IoError if a file cannot be written.
void write_evaluation(const results::JudgedFiles& judged,
                      const results::JudgeFilesOptions& options,
                      const std::vector<results::InputFile>& inputs,
                      const results::OutputFolder& out,
                      const EvaluationOutput& output,
                      results::RunRecord& record);

}  // namespace ridgeline::apps
