// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/evaluated_patches.h"

#include "apps/common/result_folder_reader.h"
#include "apps/evaluate/judged_lines.h"
#include "io/error.h"
#include "io/lines/read_lines.h"
#include "io/text_file.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

/// What the last run into a folder has evaluated, in its order.
class EvaluatedMethods {
 public:
  EvaluatedMethods(const fs::path& folder, const RunInputs& inputs) : inputs_(inputs) {
    const fs::path file = folder / "table2.json";
    if (!fs::exists(file)) return;
    is_known_ = true;
    try {
      for (const Json& row : read_json_object(file).value("rows", Json::array())) {
        const auto patch = row.at("patch").get<std::string>();
        patch_rank_.try_emplace(patch, patch_rank_.size());
        rank_.try_emplace({patch, row.at("method").get<std::string>()}, rank_.size());
      }
    } catch (const Json::exception& error) {
      throw io::IoError(file.string(), std::string("is no Table 2: ") + error.what());
    }
  }

  /// By where a file lies and what it is called: `evaluate` writes into the folder, `run` into a
  /// subfolder for each patch. A file of another run may be damaged and is not even opened.
  [[nodiscard]] bool may_hold(const std::string& subfolder, const std::string& method) const {
    if (!is_known_) return true;
    if (inputs_.is_of_files() && !subfolder.empty()) return false;
    return std::any_of(rank_.begin(), rank_.end(), [&](const auto& entry) {
      const auto& [evaluated_patch, evaluated_method] = entry.first;
      return evaluated_method == method &&
             (subfolder.empty() || evaluated_patch + "/" == subfolder);
    });
  }

  [[nodiscard]] bool contains(const std::string& patch, const std::string& method) const {
    return !is_known_ || rank_.contains({patch, method});
  }

  void arrange(std::vector<ReportPatch>& patches) const {
    if (!is_known_) return;
    std::stable_sort(patches.begin(), patches.end(), [&](const auto& a, const auto& b) {
      return patch_rank_.at(a.id) < patch_rank_.at(b.id);
    });
    for (ReportPatch& patch : patches) {
      std::stable_sort(patch.methods.begin(), patch.methods.end(),
                       [&](const auto& a, const auto& b) {
                         return rank_.at({patch.id, a.name}) < rank_.at({patch.id, b.name});
                       });
    }
  }

 private:
  const RunInputs& inputs_;
  bool is_known_ = false;
  std::map<std::string, std::size_t> patch_rank_;
  std::map<std::pair<std::string, std::string>, std::size_t> rank_;
};

std::vector<std::optional<io::Line>> in_order_of(const std::vector<std::string>& ids,
                                                 const io::LineSet& set) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < set.lines.size(); ++i) index.try_emplace(set.lines[i].id, i);
  std::vector<std::optional<io::Line>> lines(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    // the file's own order, which ids that occur twice need; else by id
    const std::string& id = ids[i];
    const auto found = index.find(id);
    if (i < set.lines.size() && set.lines[i].id == id) {
      lines[i] = set.lines[i];
    } else if (found != index.end()) {
      lines[i] = set.lines[found->second];
    }
  }
  return lines;
}

/// The file that the lines were judged from.
std::string line_file(const fs::path& evaluation,
                      const std::string& method,
                      const RunInputs& inputs) {
  if (inputs.is_of_files()) {
    const std::string given = inputs.lines_of(method);
    if (given.empty()) {
      throw io::IoError(evaluation.string(), "the file of its lines is not known");
    }
    return inputs.unchanged(given);
  }
  return (evaluation.parent_path() / fmt::format("lines.{}.geojson", method)).string();
}

void read_lines_of(const fs::path& file,
                   const RunInputs& inputs,
                   ReportMethod& method,
                   ReportPatch& patch) {
  std::vector<std::string> ids;
  for (const Json& line : method.evaluation.at("lines")) {
    ids.push_back(line.at("id").get<std::string>());
  }
  method.lines.resize(ids.size());
  read_or_note(patch, "lines are not drawn", [&] {
    method.lines = in_order_of(ids, in_metres(io::read_lines(line_file(file, method.name, inputs),
                                                             inputs.lines_options())));
  });
}

LocalFrame frame_of(const Json& evaluation) {
  const auto o = evaluation.at("origin_m").get<std::array<double, 3>>();
  return {{o[0], o[1], o[2]}};
}

ReportPatch& patch_of(const std::string& subfolder,
                      const Json& evaluation,
                      std::vector<ReportPatch>& patches) {
  const auto id = evaluation.at("patch").get<std::string>();
  for (ReportPatch& patch : patches) {
    if (patch.subfolder == subfolder && patch.id == id) return patch;
  }
  ReportPatch& patch = patches.emplace_back();
  patch.id = id;
  patch.subfolder = subfolder;
  patch.frame = frame_of(evaluation);
  return patch;
}

void read_evaluation(const fs::path& file,
                     const std::string& subfolder,
                     const RunInputs& inputs,
                     const EvaluatedMethods& evaluated,
                     std::vector<ReportPatch>& patches) {
  try {
    ReportMethod method;
    method.evaluation = read_json_object(file);
    method.name = method.evaluation.at("method").get<std::string>();
    if (!evaluated.contains(method.evaluation.at("patch").get<std::string>(), method.name)) return;
    ReportPatch& patch = patch_of(subfolder, method.evaluation, patches);
    read_lines_of(file, inputs, method, patch);
    patch.methods.push_back(std::move(method));
  } catch (const Json::exception& error) {
    throw io::IoError(file.string(), std::string("is no evaluation: ") + error.what());
  }
}

/// METHOD of evaluation.METHOD.json.
std::string method_in_name(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem.substr(stem.find('.') + 1);
}

}  // namespace

Json read_json_object(const fs::path& file) {
  Json json = Json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!json.is_object()) throw io::IoError(file.string(), "is no JSON object");
  return json;
}

std::vector<ReportPatch> read_evaluated_patches(const fs::path& folder, const RunInputs& inputs) {
  const EvaluatedMethods evaluated(folder, inputs);
  std::vector<ReportPatch> patches;
  for (const fs::path& file : evaluation_files(folder)) {
    const std::string subfolder =
        fs::equivalent(file.parent_path(), folder) ? "" : file.parent_path().filename() / "";
    if (!evaluated.may_hold(subfolder, method_in_name(file))) continue;
    read_evaluation(file, subfolder, inputs, evaluated, patches);
  }
  if (patches.empty()) {
    throw io::IoError(folder.string(),
                      "holds no evaluation.*.json of its table2.json; must be the --out of run or "
                      "evaluate");
  }
  evaluated.arrange(patches);
  return patches;
}

}  // namespace ridgeline::apps
