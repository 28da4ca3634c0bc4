// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/result_folder_reader.h"

#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/results/evaluated_methods.h"
#include "io/text_file.h"

#include <set>
#include <stdexcept>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

evaluate::Evaluation read_evaluation(const fs::path& file) {
  try {
    return evaluate::parse_evaluation(io::read_text_file(file.string()));
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.string(), error.what());
  }
}

evaluate::Table1 read_table1(const fs::path& file) {
  try {
    return evaluate::parse_table1(io::read_text_file(file.string()));
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.string(), error.what());
  }
}

/// The data that two runs must share, by file name: everything but the judged lines.
void read_run_record(const Json& json, const fs::path& file, evaluate::ResultFolder& results) {
  try {
    for (const auto& input : json.at("inputs")) {
      if (input.at("role") == "lines") continue;
      const fs::path path = input.at("path").get<std::string>();
      results.input_hashes.emplace(path.filename().string(), input.at("sha256").get<std::string>());
    }
    results.duration_s = json.at("seconds").get<double>();
  } catch (const Json::exception& error) {
    throw io::IoError(file.string(), std::string("is no run's record: ") + error.what());
  }
}

}  // namespace

evaluate::ResultFolder read_result_folder(const std::string& folder) {
  if (!fs::is_directory(folder)) {
    throw io::IoError(folder,
                      "is no folder of results; must be the --out of run, demo or evaluate");
  }
  evaluate::ResultFolder results;
  results.name = fs::path(folder).lexically_normal().string();
  const fs::path record = fs::path(folder) / "run.json";
  const Json run = fs::exists(record) ? read_json_object(record) : Json::object();
  const bool of_files = run.contains("command") && run["command"] == "evaluate";
  results.is_of_line_files = of_files;
  const EvaluatedMethods evaluated(folder, of_files);
  // in the folder of an evaluation of files it is an earlier run's
  const fs::path table1 = fs::path(folder) / "table1.json";
  if (!of_files && fs::exists(table1)) results.matching = read_table1(table1);
  std::set<EvaluatedMethods::PatchAndMethod> found;
  for (const EvaluationFile& file : evaluated.files()) {
    evaluate::Evaluation evaluation = read_evaluation(file.path);
    if (!evaluated.contains({evaluation.patch, evaluation.method})) continue;
    found.emplace(evaluation.patch, evaluation.method);
    results.evaluations.push_back(std::move(evaluation));
  }
  if (results.evaluations.empty()) {
    throw io::IoError(folder,
                      "holds no evaluation.*.json; must be the --out of run, demo or evaluate");
  }
  evaluated.check_all_found(found);
  if (fs::exists(record)) read_run_record(run, record, results);
  return results;
}

}  // namespace ridgeline::results
