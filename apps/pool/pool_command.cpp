// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/outcome.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/report/write_report.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/pool_runs.h"
#include "evaluate/files/run_record.h"
#include "evaluate/files/write_results.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/decoy_table.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/terminal_table.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

namespace ridgeline::apps {
namespace {

namespace fs = std::filesystem;
using evaluate::Json;

struct PoolArguments {
  std::vector<std::string> folders;
  std::string out;
  bool report = true;
  PageFacts page;
};

/// The entry of a run in run.json: its area, the figures of its first line file, and the path of
/// its report relative to `out`.
Json run_entry(const results::AreaRun& run, const std::string& out) {
  Json entry{{"folder", run.folder},
             {"area", run.bounds},
             {"seconds", run.run.value("seconds", 0.0)},
             {"peak_memory_mib", run.run.value("peak_memory_mib", 0.0)},
             {"n_lines", 0},
             {"n_evaluated", 0},
             {"rms_m", nullptr}};
  const auto& classes = run.evaluations.front().classes;
  if (const auto* const total = evaluate::find_class(classes, evaluate::kTotal)) {
    entry["n_lines"] = total->n_lines;
    entry["n_evaluated"] = total->n_evaluated;
    if (total->rms_m) entry["rms_m"] = *total->rms_m;
  }
  const fs::path page = fs::path(run.folder) / "report.html";
  if (fs::exists(page))
    entry["page"] = fs::proximate(fs::absolute(page), fs::absolute(out)).generic_string();
  return entry;
}

/// Records the facts of the cloud that all runs share, and the runs.
void record_runs(const results::PooledRuns& pooled,
                 const std::string& out,
                 results::RunRecord& record) {
  Json cloud = Json::object();
  for (const char* key : {"crs", "horizontal_unit_m", "vertical_unit_m", "plan_scale"}) {
    const Json& of_first = pooled.runs.front().run.at("cloud");
    if (of_first.contains(key)) cloud[key] = of_first[key];
  }
  record.set("cloud", std::move(cloud));
  Json runs = Json::array();
  for (const results::AreaRun& run : pooled.runs) runs.push_back(run_entry(run, out));
  record.set("runs", std::move(runs));
}

/// Prints the outcome.
/// @return the messages other than the table
std::vector<std::string> say_outcome(const std::vector<evaluate::Evaluation>& evaluations) {
  if (has_figures(evaluations)) {
    say("{}\n", evaluate::to_terminal(evaluate::make_table2(evaluations)));
  }
  if (const std::string decoys = evaluate::decoys_to_terminal(evaluations); !decoys.empty()) {
    say("{}\n", decoys);
  }
  if (const std::string found = evaluate::completeness_to_terminal(evaluations); !found.empty()) {
    say("{}\n", found);
  }
  std::vector<std::string> messages = judging_messages(evaluations.front().patch, evaluations);
  std::ranges::move(evaluate::shift_messages(evaluations, false), std::back_inserter(messages));
  for (const std::string& message : messages) say("{}\n", message);
  return messages;
}

/// Files that must not be overwritten: the data of the runs and their results.
std::vector<std::string> input_paths(const results::PooledRuns& pooled) {
  std::vector<std::string> paths;
  for (const Json& input : pooled.inputs) paths.push_back(input.at("path").get<std::string>());
  for (const results::AreaRun& run : pooled.runs) {
    for (const evaluate::Evaluation& e : pooled.evaluations) {
      paths.push_back(
          (fs::path(run.folder) / results::evaluation_names(e.method).front()).string());
    }
  }
  return paths;
}

int run_pool(const PoolArguments& a) {
  results::RunRecord record("pool");
  const results::PooledRuns pooled = results::pool_runs(a.folders);
  record.end_stage("pool");
  record.set_options(pooled.options);
  record_runs(pooled, a.out, record);
  for (const Json& input : pooled.inputs) record.add_recorded_input(input);
  record.add_warnings(pooled.warnings);
  warn_of(pooled.warnings);
  const results::OutputFolder out(a.out, input_paths(pooled));
  std::vector<results::TruthRows> truth;
  for (const evaluate::Evaluation& e : pooled.evaluations) {
    results::write_evaluation_files(e, out, "");
    truth.push_back(results::compare_with_truth(e, {}, std::nullopt));
  }
  results::write_tables(pooled.evaluations, truth, out);
  results::write_models(pooled.models, out);
  record.set("messages", say_outcome(pooled.evaluations));
  record.set("page", to_json(a.page));
  record.end_stage("write");
  out.write_record(record.to_json());
  say("Tables: {}\n", (fs::path(a.out) / "table2.md").string());
  write_report_of_run(a.out, a.report);
  return kDone;
}

}  // namespace

Run add_pool(CLI::App& subcommand) {
  auto a = std::make_shared<PoolArguments>();
  subcommand.add_option("runs", a->folders, "folders that `evaluate --area` wrote")->required();
  subcommand.add_option("--out", a->out, "folder for the results of all lines")->required();
  add_page_options(subcommand, a->page);
  add_report_flag(subcommand, a->report);
  return [a] { return run_pool(*a); };
}

}  // namespace ridgeline::apps
