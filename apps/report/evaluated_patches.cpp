// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/evaluated_patches.h"

#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/lines/read_lines.h"
#include "io/results/evaluated_methods.h"
#include "io/results/judged_lines.h"
#include "io/text_file.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

void arrange(std::vector<ReportPatch>& patches, const results::EvaluatedMethods& evaluated) {
  std::stable_sort(patches.begin(), patches.end(), [&](const auto& a, const auto& b) {
    return evaluated.rank(a.id) < evaluated.rank(b.id);
  });
  for (ReportPatch& patch : patches) {
    std::stable_sort(patch.methods.begin(), patch.methods.end(), [&](const auto& a, const auto& b) {
      return evaluated.rank({patch.id, a.name}) < evaluated.rank({patch.id, b.name});
    });
  }
}

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
    method.lines =
        in_order_of(ids, results::in_metres(io::read_lines(line_file(file, method.name, inputs),
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

void read_evaluation(const results::EvaluationFile& file,
                     const RunInputs& inputs,
                     const results::EvaluatedMethods& evaluated,
                     std::set<results::EvaluatedMethods::PatchAndMethod>& found,
                     std::vector<ReportPatch>& patches) {
  try {
    ReportMethod method;
    const std::string text = io::read_text_file(file.path.string());
    (void)evaluate::parse_judged_lines(text);  // that what is used below is there, with its types
    method.evaluation = Json::parse(text);
    method.name = method.evaluation.at("method").get<std::string>();
    const auto patch_id = method.evaluation.at("patch").get<std::string>();
    if (!evaluated.contains({patch_id, method.name})) return;
    found.emplace(patch_id, method.name);
    ReportPatch& patch = patch_of(file.subfolder, method.evaluation, patches);
    read_lines_of(file.path, inputs, method, patch);
    patch.methods.push_back(std::move(method));
  } catch (const Json::exception& error) {
    throw io::IoError(file.path.string(), std::string("is no evaluation: ") + error.what());
  } catch (const std::invalid_argument& error) {
    throw io::IoError(file.path.string(), error.what());
  }
}

}  // namespace

std::vector<ReportPatch> read_evaluated_patches(const fs::path& folder, const RunInputs& inputs) {
  const results::EvaluatedMethods evaluated(folder, inputs.is_of_files());
  std::vector<ReportPatch> patches;
  std::set<results::EvaluatedMethods::PatchAndMethod> found;
  for (const results::EvaluationFile& file : evaluated.files()) {
    read_evaluation(file, inputs, evaluated, found, patches);
  }
  if (patches.empty()) {
    throw io::IoError(folder.string(),
                      "holds no evaluation.*.json of its table2.json; must be the --out of run or "
                      "evaluate");
  }
  evaluated.check_all_found(found);
  arrange(patches, evaluated);
  return patches;
}

}  // namespace ridgeline::apps
