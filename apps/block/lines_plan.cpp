// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/lines_plan.h"

#include "io/error.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/results/version.h"
#include "reconstruct/geometry/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
using Place = std::pair<std::int64_t, std::int64_t>;  ///< row, column

/// The cell of a line's middle; nothing for a line that is not in range.
std::optional<Place> place_of(const evaluate::JudgedLine& line,
                              const LocalFrame& frame,
                              double size_m) {
  if (!evaluate::in_range(line.segment)) return std::nullopt;
  const Eigen::Vector3d middle = frame.world_from_local(midpoint(line.segment));
  return Place{static_cast<std::int64_t>(std::floor(middle.y() / size_m)),
               static_cast<std::int64_t>(std::floor(middle.x() / size_m))};
}

std::int64_t modified_s(const std::string& path) {
  const auto time = fs::file_time_type::clock::to_sys(fs::last_write_time(path));
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

/// A path as the plan states it: hosts may reach the folder of the block file by another path.
std::string beside(const std::string& block_file, const std::string& path) {
  const auto normal = [](const fs::path& p) { return fs::absolute(p).lexically_normal(); };
  return normal(path).lexically_relative(normal(block_file).parent_path()).string();
}

/// The file itself; of a folder (LIMAP's tracks) all its files.
std::vector<std::string> files_of(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

/// The entry of the same role and path; null if there is none.
Json same_input(const Json& inputs, const Json& wanted) {
  const auto found = std::ranges::find_if(inputs, [&](const Json& input) {
    return input["path"] == wanted["path"] && input["role"] == wanted["role"];
  });
  return found == inputs.end() ? Json() : *found;
}

/// Whether an input is the same. A file with a hash may have been copied, which changes its time.
bool is_same(Json a, Json b) {
  if (!a.is_object() || !b.is_object()) return false;
  if (a.contains("sha256")) {
    a.erase("modified_s");
    b.erase("modified_s");
  }
  return a == b;
}

std::optional<PlanDifference> input_difference(const Json& planned, const Json& now) {
  for (const Json& input : now) {
    const Json before = same_input(planned, input);
    if (is_same(before, input)) continue;
    return PlanDifference{
        input["path"].get<std::string>(),
        before.is_null() ? "is no input of the plan" : "has changed since the plan was made"};
  }
  for (const Json& input : planned) {
    if (same_input(now, input).is_null()) {
      return PlanDifference{input["path"].get<std::string>(), "is no longer an input"};
    }
  }
  return std::nullopt;
}

std::optional<PlanDifference> option_difference(const Json& planned, const Json& now) {
  if (planned == now) return std::nullopt;
  const Json::json_pointer at(Json::diff(planned, now).at(0)["path"].get<std::string>());
  const auto value = [&](const Json& json) {
    return json.contains(at) ? json[at].dump() : std::string("not there");
  };
  return PlanDifference{"option " + at.to_string().substr(1),
                        fmt::format("is {}, in the plan {}", value(now), value(planned))};
}

}  // namespace

std::vector<LinesCell> cells_of(const results::LineSets& lines,
                                const LocalFrame& frame,
                                double size_m) {
  std::map<Place, std::size_t> n_lines;
  std::size_t n_elsewhere = 0;
  for (const auto& set : lines) {
    for (const evaluate::JudgedLine& line : set) {
      const std::optional<Place> place = place_of(line, frame, size_m);
      ++(place ? n_lines[*place] : n_elsewhere);
    }
  }
  if (n_elsewhere > 0) {
    if (n_lines.empty()) n_lines[{0, 0}] = 0;
    n_lines.begin()->second += n_elsewhere;
  }
  std::vector<LinesCell> cells;
  cells.reserve(n_lines.size());
  for (const auto& [place, n] : n_lines) cells.push_back({place.second, place.first, n});
  return cells;
}

std::vector<results::LineNumbers> numbers_by_cell(const std::vector<LinesCell>& cells,
                                                  const results::LineSets& lines,
                                                  const LocalFrame& frame,
                                                  double size_m) {
  check(cells == cells_of(lines, frame, size_m),
        "numbers_by_cell: the cells of the plan are not those of the lines");
  std::map<Place, std::size_t> index_of;
  for (const LinesCell& cell : cells) index_of[{cell.row, cell.column}] = index_of.size();
  std::vector<results::LineNumbers> numbers(cells.size(), results::LineNumbers(lines.size()));
  for (std::size_t set = 0; set < lines.size(); ++set) {
    for (std::size_t i = 0; i < lines[set].size(); ++i) {
      const std::optional<Place> place = place_of(lines[set][i], frame, size_m);
      numbers[place ? index_of.at(*place) : 0][set].push_back(i);
    }
  }
  return numbers;
}

std::string LinesPlan::to_json() const {
  Json json = made_from;
  json["cells"] = Json::array();
  for (const LinesCell& cell : cells) {
    json["cells"].push_back(
        {{"column", cell.column}, {"row", cell.row}, {"n_lines", cell.n_lines}});
  }
  return json.dump(1) + "\n";
}

LinesPlan read_lines_plan(const std::string& path) {
  if (!fs::exists(path)) throw io::IoError(path, "is not there; make the plan of the block first");
  LinesPlan plan;
  try {
    plan.made_from = Json::parse(io::read_text_file(path));
    for (const Json& cell : plan.made_from.at("cells")) {
      plan.cells.push_back({cell.at("column").get<std::int64_t>(),
                            cell.at("row").get<std::int64_t>(),
                            cell.at("n_lines").get<std::size_t>()});
    }
    plan.made_from.erase("cells");
    for (const char* key : {"program", "block", "inputs", "options"}) (void)plan.made_from.at(key);
  } catch (const Json::exception&) {
    throw io::IoError(path, "is no plan of a block of lines; use another folder");
  }
  return plan;
}

Json InputStates::now(const std::string& block_file,
                      const std::vector<results::InputFile>& inputs,
                      Json options) {
  Json json;
  json["program"] = fmt::format("{} {}", results::kVersion, results::kGitHash);
  json["block"] = io::sha256_of_file(block_file);
  json["options"] = std::move(options);
  json["inputs"] = Json::array();
  for (const results::InputFile& input : inputs) {
    if (!fs::exists(input.path)) throw io::IoError(input.path, "is not there");
    for (const std::string& file : files_of(input.path)) {
      add(input.role, file, block_file, json["inputs"]);
    }
  }
  return json;
}

void InputStates::add(const std::string& role,
                      const std::string& path,
                      const std::string& block_file,
                      Json& inputs) {
  const std::uint64_t bytes = fs::file_size(path);
  const std::int64_t time_s = modified_s(path);
  Json input{
      {"role", role}, {"path", beside(block_file, path)}, {"bytes", bytes}, {"modified_s", time_s}};
  if (role == "lines" || role == "reference") {
    Hashed& hashed = hashed_[path];
    if (hashed.sha256.empty() || hashed.bytes != bytes || hashed.modified_s != time_s) {
      hashed = {bytes, time_s, io::sha256_of_file(path)};
    }
    input["sha256"] = hashed.sha256;
  }
  inputs.push_back(std::move(input));
}

std::optional<PlanDifference> difference(const Json& planned, const Json& now) {
  if (planned["program"] != now["program"]) {
    return PlanDifference{"ridgeline " + now["program"].get<std::string>(),
                          "is not the version of the plan, " + planned["program"].dump()};
  }
  if (planned["block"] != now["block"]) {
    return PlanDifference{"the block file", "has changed since the plan was made"};
  }
  if (auto found = input_difference(planned["inputs"], now["inputs"])) return found;
  return option_difference(planned["options"], now["options"]);
}

}  // namespace ridgeline::apps
