// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/evaluated_methods.h"

#include "evaluate/tables/summary_json.h"
#include "io/error.h"
#include "io/text_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

/// METHOD of evaluation.METHOD.json, as JSON holds a name that is not UTF-8.
std::string method_in_name(const fs::path& file) {
  const std::string stem = file.stem().string();
  return Json::parse(evaluate::dump(Json(stem.substr(stem.find('.') + 1)))).get<std::string>();
}

}  // namespace

Json read_json_object(const fs::path& file) {
  Json json = Json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!json.is_object()) throw io::IoError(file.string(), "is no JSON object");
  return json;
}

EvaluatedMethods::EvaluatedMethods(fs::path folder, bool of_files)
    : folder_(std::move(folder)), of_files_(of_files) {
  const fs::path file = folder_ / "table2.json";
  if (!fs::exists(file)) return;
  is_known_ = true;
  try {
    const Json table = read_json_object(file);
    for (const Json& row : table.at("rows")) {
      const auto patch = row.at("patch").get<std::string>();
      patch_rank_.try_emplace(patch, patch_rank_.size());
      rank_.try_emplace({patch, row.at("method").get<std::string>()}, rank_.size());
    }
  } catch (const Json::exception& error) {
    throw io::IoError(file.string(), std::string("is no Table 2: ") + error.what());
  }
}

bool EvaluatedMethods::may_hold(const EvaluationFile& file) const {
  if (!is_known_) return true;
  if (of_files_ && !file.subfolder.empty()) return false;
  const std::string method = method_in_name(file.path);
  return std::any_of(rank_.begin(), rank_.end(), [&](const auto& entry) {
    const auto& [evaluated_patch, evaluated_method] = entry.first;
    return evaluated_method == method &&
           (file.subfolder.empty() || evaluated_patch + "/" == file.subfolder);
  });
}

std::vector<EvaluationFile> EvaluatedMethods::files() const {
  std::vector<EvaluationFile> files;
  constexpr int kDeepest = 1;  // DIR/PATCH/evaluation.METHOD.json
  for (auto it = fs::recursive_directory_iterator(folder_); it != fs::end(it); ++it) {
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    const std::string name = it->path().filename().string();
    if (!name.starts_with("evaluation.") || !name.ends_with(".json")) continue;
    EvaluationFile file{it->path(), ""};
    if (it.depth() > 0) file.subfolder = it->path().parent_path().filename() / "";
    if (may_hold(file)) files.push_back(std::move(file));
  }
  std::sort(files.begin(), files.end(),
            [](const EvaluationFile& a, const EvaluationFile& b) { return a.path < b.path; });
  return files;
}

bool EvaluatedMethods::contains(const PatchAndMethod& evaluation) const {
  return !is_known_ || rank_.contains(evaluation);
}

void EvaluatedMethods::check_all_found(const std::set<PatchAndMethod>& found) const {
  for (const auto& [evaluation, rank] : rank_) {
    if (found.contains(evaluation)) continue;
    throw io::IoError(
        (folder_ / "table2.json").string(),
        fmt::format("names method {} of patch {}, but its evaluation.{}.json is gone; "
                    "run it again",
                    evaluation.second, evaluation.first, evaluation.second));
  }
}

std::size_t EvaluatedMethods::rank(const std::string& patch) const {
  return is_known_ ? patch_rank_.at(patch) : 0;
}

std::size_t EvaluatedMethods::rank(const PatchAndMethod& evaluation) const {
  return is_known_ ? rank_.at(evaluation) : 0;
}

}  // namespace ridgeline::results
