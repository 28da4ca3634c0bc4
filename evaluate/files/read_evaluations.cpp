// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/read_evaluations.h"

#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/files/text_file.h"
#include "io/kinds/folder_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;
using evaluate::Json;

/// METHOD in evaluation.METHOD.json, with invalid UTF-8 bytes replaced as in JSON.
std::string method_in_name(const fs::path& file) {
  const std::string stem = file.stem().string();
  return Json::parse(evaluate::dump(Json(stem.substr(stem.find('.') + 1)))).get<std::string>();
}

/// Patches and methods of a table2.json. For a flat folder, only those of the first patch: the
/// following rows are parts of a block, whose lines are in the evaluation of the block.
class TableOfRun {
 public:
  /// Throws IoError if the file is not such a table.
  TableOfRun(fs::path file, bool is_flat)
      : file_(std::move(file)), is_flat_(is_flat), exists_(fs::exists(file_)) {
    if (!exists_) return;
    try {
      const Json table = read_json_object(file_);
      for (const Json& row : table.at("rows")) {
        const auto patch = row.at("patch").get<std::string>();
        if (is_flat_ && !rank_.empty() && patch != rank_.begin()->first.first) break;
        rank_.try_emplace({patch, row.at("method").get<std::string>()}, rank_.size());
      }
    } catch (const Json::exception& error) {
      throw io::IoError(file_.string(), std::string("is not a Table 2: ") + error.what());
    }
  }

  /// Whether the table may list the evaluation, judging by the path of its file.
  [[nodiscard]] bool may_name(const FoundEvaluation& file) const {
    if (!exists_) return true;
    if (is_flat_ && !file.subfolder.empty()) return false;
    const std::string method = method_in_name(file.path);
    return std::ranges::any_of(rank_, [&](const auto& entry) {
      const auto& [named_patch, named_method] = entry.first;
      return named_method == method &&
             (file.subfolder.empty() || named_patch + "/" == file.subfolder);
    });
  }

  /// The position of an evaluation in the table; std::nullopt if the table does not list it.
  [[nodiscard]] std::optional<std::size_t> rank_of(const Evaluation& evaluation) const {
    if (!exists_) return 0;
    const auto entry = rank_.find({evaluation.patch, evaluation.method});
    return entry == rank_.end() ? std::nullopt : std::optional(entry->second);
  }

  void check_all_found(const std::vector<FoundEvaluation>& found) const {
    for (const auto& [name, rank] : rank_) {
      const auto is_it = [&rank = rank](const FoundEvaluation& one) { return one.rank == rank; };
      if (std::ranges::any_of(found, is_it)) continue;
      throw io::IoError(
          file_.string(),
          fmt::format(
              "lists method {} of patch {}, but evaluation.{}.json is missing; run it again",
              name.second, name.first, name.second));
    }
  }

 private:
  fs::path file_;
  bool is_flat_, exists_;
  std::map<std::pair<std::string, std::string>, std::size_t> rank_;
};

/// The evaluation files of a folder, found by their names and sorted by path. Their contents are
/// not read yet.
std::vector<FoundEvaluation> evaluation_files(const fs::path& folder) {
  std::vector<FoundEvaluation> files;
  constexpr int kMaxDepth = 1;  // DIR/PATCH/evaluation.METHOD.json
  for (auto it = fs::recursive_directory_iterator(folder); it != fs::end(it); ++it) {
    if (it.depth() >= kMaxDepth) it.disable_recursion_pending();
    const std::string name = it->path().filename().string();
    if (!name.starts_with("evaluation.") || !name.ends_with(".json")) continue;
    FoundEvaluation& file = files.emplace_back();
    file.path = it->path();
    if (it.depth() > 0) file.subfolder = it->path().parent_path().filename() / "";
  }
  std::ranges::sort(files, {}, &FoundEvaluation::path);
  return files;
}

Evaluation read_evaluation(const fs::path& file) {
  try {
    return evaluate::parse_evaluation(io::read_text_file(file.string()));
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.string(), error.what());
  }
}

}  // namespace

Json read_json_object(const fs::path& file) {
  Json json = Json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!json.is_object()) throw io::IoError(file.string(), "is not a JSON object");
  return json;
}

std::vector<FoundEvaluation> read_evaluations(const fs::path& folder, bool is_flat) {
  const TableOfRun table(folder / "table2.json", is_flat);
  std::vector<FoundEvaluation> found;
  for (FoundEvaluation& file : evaluation_files(folder)) {
    if (!table.may_name(file)) continue;
    file.evaluation = read_evaluation(file.path);
    const std::optional<std::size_t> rank = table.rank_of(file.evaluation);
    if (!rank) continue;
    file.rank = *rank;
    found.push_back(std::move(file));
  }
  if (found.empty()) {
    const io::FileKind kind = io::kind_of_folder(folder);
    const bool is_other = kind.group != io::FileGroup::kResultFolder;
    const std::string what = is_other ? ": it is " + kind.what : "";
    throw io::IoError(folder.string(),
                      fmt::format("holds no evaluation.*.json{}; must be the `out` of run, block, "
                                  "demo, evaluate or pool",
                                  what));
  }
  table.check_all_found(found);
  return found;
}

}  // namespace ridgeline::results
