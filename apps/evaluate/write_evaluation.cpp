// SPDX-License-Identifier: BSD-3-Clause
#include "apps/evaluate/write_evaluation.h"

#include "apps/common/outcome.h"
#include "apps/common/say.h"
#include "apps/report/write_report.h"
#include "evaluate/files/judged_attributes.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/model_files.h"
#include "evaluate/files/write_results.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/decoy_table.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/terminal_table.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

namespace ridgeline::apps {
namespace {

void record_inputs(const std::vector<results::InputFile>& inputs,
                   const std::vector<std::string>& unread_clouds,
                   results::RunRecord& record) {
  const std::set<std::string> unread(unread_clouds.begin(), unread_clouds.end());
  for (const results::InputFile& input : inputs) {
    if (unread.contains(input.path)) continue;
    record.add_input(input);
  }
  record.end_stage("hash_inputs");
}

/// Prints the outcome.
/// @return the messages other than the table
std::vector<std::string> say_outcome(const results::JudgedFiles& judged,
                                     const results::JudgeFilesOptions& options) {
  if (has_figures(judged.evaluations)) {
    say("{}\n", evaluate::to_terminal(evaluate::make_table2(judged.evaluations)));
  }
  if (const std::string decoys = evaluate::decoys_to_terminal(judged.evaluations);
      !decoys.empty()) {
    say("{}\n", decoys);
  }
  if (const std::string found = evaluate::completeness_to_terminal(judged.evaluations);
      !found.empty()) {
    say("{}\n", found);
  }
  std::vector<std::string> messages = judging_messages(options.patch_name, judged.evaluations);
  std::ranges::move(evaluate::shift_messages(judged.evaluations, options.apply_shift),
                    std::back_inserter(messages));
  std::ranges::move(results::model_messages(judged), std::back_inserter(messages));
  for (const std::string& message : messages) say("{}\n", message);
  return messages;
}

}  // namespace

std::vector<results::InputFile> inputs_of(const results::JudgeFilesOptions& options,
                                          const std::string& config) {
  std::vector<results::InputFile> inputs;
  for (const std::string& path : options.line_paths) inputs.push_back({"lines", path});
  for (const std::string& path : io::expand_patterns(options.cloud_paths)) {
    inputs.push_back({"cloud", path});
  }
  if (options.patch) {
    inputs.push_back({"patch", options.patch->path});
    for (const std::string& path : options.patch->orientation_files)
      inputs.push_back({"orientation", path});
  }
  if (options.reference_lines) inputs.push_back({"reference", *options.reference_lines});
  if (!config.empty()) inputs.push_back({"config", config});
  if (!options.geoid.empty()) inputs.push_back({"geoid", options.geoid});
  return inputs;
}

void write_evaluation(const results::JudgedFiles& judged,
                      const results::JudgeFilesOptions& options,
                      const std::vector<results::InputFile>& inputs,
                      const results::OutputFolder& out,
                      const EvaluationOutput& output,
                      results::RunRecord& record) {
  warn_of(judged.warnings);
  record.add_warnings(judged.warnings);
  record_inputs(inputs, judged.unread_clouds, record);
  results::write_judged(judged, results::map_schema_named(output.schema), out, "");
  if (!output.plane_points.empty()) results::write_plane_points(output.plane_points, judged);
  results::write_tables(judged.evaluations, judged.truth, out);
  results::write_models(results::model_tables(judged, options.by), out);
  const std::vector<std::string> messages = say_outcome(judged, options);
  record.end_stage("write");
  record.set("messages", messages);
  record.set("page", to_json(output.page));
  out.write_record(record.to_json());
  if (!output.attributes.empty()) results::write_model_with_figures(output.attributes, judged, 0);
  const std::filesystem::path folder = output.folder;
  for (const evaluate::Evaluation& e : judged.evaluations) {
    say("Map for QGIS: {}\n", (folder / results::map_name(e.method)).string());
  }
  if (!results::model_messages(judged).empty())
    say("Buildings: {}\n", (folder / "buildings.csv").string());
  say("Tables: {}\n", (folder / "table2.md").string());
  write_report_of_run(output.folder, output.report);
}

}  // namespace ridgeline::apps
