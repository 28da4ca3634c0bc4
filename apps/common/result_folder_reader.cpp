// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/result_folder_reader.h"

#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/text_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

evaluate::Evaluation read_evaluation(const fs::path& file) {
  try {
    return evaluate::parse_evaluation(io::read_text_file(file.string()));
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.string(), error.what());
  }
}

/// The data that two runs must share, by file name: everything but the judged lines.
void read_run_record(const fs::path& file, evaluate::ResultFolder& results) {
  if (!fs::exists(file)) return;
  const auto json = nlohmann::json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!json.is_object()) throw io::IoError(file.string(), "is not JSON; must be a run's record");
  try {
    for (const auto& input : json.at("inputs")) {
      if (input.at("role") == "lines") continue;
      const fs::path path = input.at("path").get<std::string>();
      results.input_hashes[path.filename().string()] = input.at("sha256").get<std::string>();
    }
    results.duration_s = json.at("seconds").get<double>();
  } catch (const nlohmann::json::exception& error) {
    throw io::IoError(file.string(), std::string("is no run's record: ") + error.what());
  }
}

}  // namespace

std::vector<fs::path> evaluation_files(const fs::path& folder) {
  std::vector<fs::path> files;
  constexpr int kDeepest = 1;  // DIR/PATCH/evaluation.METHOD.json
  for (auto it = fs::recursive_directory_iterator(folder); it != fs::end(it); ++it) {
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    const std::string name = it->path().filename().string();
    if (name.starts_with("evaluation.") && name.ends_with(".json")) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

evaluate::ResultFolder read_result_folder(const std::string& folder) {
  if (!fs::is_directory(folder)) throw io::IoError(folder, "is no folder of results");
  evaluate::ResultFolder results;
  results.name = fs::path(folder).lexically_normal().string();
  for (const fs::path& file : evaluation_files(folder)) {
    results.evaluations.push_back(read_evaluation(file));
  }
  if (results.evaluations.empty()) {
    throw io::IoError(folder, "holds no evaluation.*.json; must be the --out of an evaluation");
  }
  read_run_record(fs::path(folder) / "run.json", results);
  return results;
}

}  // namespace ridgeline::apps
