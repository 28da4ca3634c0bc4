// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/result_folder_reader.h"

#include "evaluate/files/read_evaluations.h"
#include "io/error.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/kinds/recognise.h"

#include <stdexcept>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

/// Reads the run time and the hashes, by file name, of the data that two runs must share: all
/// inputs except the judged lines and the options.
void read_run_record(const Json& json, const fs::path& file, evaluate::ResultFolder& results) {
  try {
    for (const auto& input : json.at("inputs")) {
      if (input.at("role") == "lines" || input.at("role") == "config") continue;
      const fs::path path = input.at("path").get<std::string>();
      results.input_hashes.emplace(path.filename().string(), input.at("sha256").get<std::string>());
    }
    results.duration_s = json.at("seconds").get<double>();
    if (json.contains("n_views"))
      results.n_views = json["n_views"].get<std::map<std::string, std::size_t>>();
  } catch (const Json::exception& error) {
    throw io::IoError(file.string(), std::string("is not a run record: ") + error.what());
  }
}

/// Whether the rows of a patch's file determine the numbers of its lines.
bool numbers_lines(const std::string& name) {
  return name.starts_with("segments.") || name == "matches.csv" || name == "tracks.csv";
}

void read_id_hashes(const fs::path& folder, evaluate::ResultFolder& results) {
  for (const evaluate::Evaluation& evaluation : results.evaluations) {
    const fs::path files = folder / evaluation.patch;
    if (results.id_hashes.contains(evaluation.patch) || !fs::is_directory(files)) continue;
    for (const auto& entry : fs::directory_iterator(files)) {
      if (numbers_lines(entry.path().filename().string()))
        results.id_hashes[evaluation.patch].insert(io::sha256_of_file(entry.path().string()));
    }
  }
}

}  // namespace

std::optional<bool> joint_adjusts_to_faces(const Json& run) {
  const auto option = [&](const char* key) -> std::optional<bool> {
    const Json::json_pointer place(std::string("/options/reconstruct/") + key);
    if (!run.contains(place) || !run[place].is_boolean()) return std::nullopt;
    return run[place].get<bool>();
  };
  const std::optional<bool> faces_beside = option("faces_beside");
  if (!faces_beside) return std::nullopt;
  return *faces_beside && option("surface").value_or(true);
}

Json read_run_json(const fs::path& folder) {
  const fs::path file = folder / "run.json";
  return fs::exists(file) ? read_json_object(file) : Json::object();
}

bool is_of_line_files(const Json& run) {
  const auto command = run.find("command");
  return command != run.end() && (*command == "evaluate" || *command == "pool");
}

evaluate::Table1 read_matching(const fs::path& folder, bool of_files) {
  const fs::path file = folder / "table1.json";
  if (of_files || !fs::exists(file)) return {};
  try {
    return evaluate::parse_table1(io::read_text_file(file.string()));
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.string(), error.what());
  }
}

evaluate::ResultFolder read_result_folder(const std::string& folder) {
  constexpr const char* kWhat =
      "is not a results folder; must be the `out` of run, block, demo, evaluate or pool";
  if (!fs::exists(folder)) throw io::MissingFileError(folder, kWhat);
  if (!fs::is_directory(folder)) {
    io::require_kind(folder, io::FileGroup::kResultFolder);
    throw io::IoError(folder, kWhat);
  }
  evaluate::ResultFolder results;
  results.name = fs::path(folder).lexically_normal().string();
  const Json run = read_run_json(folder);
  const bool of_files = is_of_line_files(run);
  const bool is_block = run.contains("command") && run["command"] == "block";
  results.is_of_line_files = of_files;
  results.matching = read_matching(folder, of_files);
  for (FoundEvaluation& found : read_evaluations(folder, of_files || is_block)) {
    results.evaluations.push_back(std::move(found.evaluation));
  }
  if (!of_files) read_id_hashes(folder, results);
  const fs::path record = fs::path(folder) / "run.json";
  if (fs::exists(record)) read_run_record(run, record, results);
  results.joint_adjusts_to_faces = joint_adjusts_to_faces(run);
  return results;
}

}  // namespace ridgeline::results
