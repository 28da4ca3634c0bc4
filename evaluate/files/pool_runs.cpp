// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/pool_runs.h"

#include "evaluate/files/finish_judging.h"
#include "evaluate/files/judge_decoys.h"
#include "evaluate/files/pool_models.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/files/write_results.h"
#include "evaluate/judge/plane_ids.h"
#include "evaluate/statistics/frame_check.h"
#include "evaluate/tables/evaluation_json.h"
#include "io/error.h"
#include "io/files/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;
using evaluate::Json;

[[noreturn]] void refuse_run(const std::string& folder, const std::string& problem) {
  throw io::IoError(folder, problem);
}

/// Reads an evaluation by its file, because read_evaluations() does not find one without lines, as
/// an area may have: Table 2 does not list it.
Evaluation read_area_evaluation(const std::string& file) {
  try {
    Evaluation evaluation = evaluate::parse_evaluation(io::read_text_file(file));
    if (!evaluation.area) refuse_run(file, "has no area; judge it again");
    return evaluation;
  } catch (const std::invalid_argument& error) {
    refuse_run(file, error.what());
  }
}

AreaRun read_run(const std::string& folder) {
  AreaRun run{.folder = folder, .run = {}, .bounds = {}, .evaluations = {}};
  if (!fs::is_directory(folder)) throw io::MissingFileError(folder, "there is no such folder");
  run.run = read_run_json(folder);
  const Json options = run.run.value("options", Json::object());
  if (run.run.value("command", "") != "evaluate" || !options.contains("area")) {
    refuse_run(folder, "is not the judgement of an area of the lines");
  }
  if (options.value("apply_shift", false)) {
    refuse_run(
        folder,
        "its lines were moved by the shift of their own area (`apply_shift`); judge it without");
  }
  run.bounds = options.at("area").get<std::array<double, 4>>();
  for (const Json& lines : options.at("lines")) {
    const std::string name = evaluation_names(stem_of(lines.get<std::string>())).front();
    run.evaluations.push_back(read_area_evaluation((fs::path(folder) / name).string()));
  }
  return run;
}

/// The options on which results depend, without the area and paths.
Json options_of(const AreaRun& run) {
  Json options = run.run.at("options");
  for (const char* key : {"area", "lines", "cloud", "patch", "geoid"}) options.erase(key);
  return options;
}

/// The reference system of the cloud and its units.
Json system_of(const AreaRun& run) {
  Json system = Json::object();
  for (const char* key : {"crs", "horizontal_unit_m", "vertical_unit_m", "plan_scale"}) {
    if (run.run.at("cloud").contains(key)) system[key] = run.run["cloud"][key];
  }
  const Eigen::Vector3d& origin_m = run.evaluations.front().origin_m;
  system["origin_m"] = {origin_m.x(), origin_m.y(), origin_m.z()};
  return system;
}

/// Hashes by role and name of the inputs that all runs must share: all except the cloud, of which a
/// run only reads the files near its lines.
Json shared_inputs_of(const AreaRun& run) {
  Json hashes = Json::object();
  for (const Json& input : run.run.at("inputs")) {
    const auto role = input.at("role").get<std::string>();
    if (role == "cloud") continue;
    const std::string name = fs::path(input.at("path").get<std::string>()).filename().string();
    hashes[fmt::format("{} {}", role, name)] = input.at("sha256");
  }
  return hashes;
}

void require_same(const AreaRun& first,
                  const AreaRun& other,
                  const char* what,
                  const Json& of_first,
                  const Json& of_other) {
  const Json a = of_first.flatten();
  const Json b = of_other.flatten();
  for (const Json* const side : {&a, &b}) {
    for (const auto& [key, value] : side->items()) {
      const Json in_a = a.value(key, Json());
      const Json in_b = b.value(key, Json());
      if (in_a == in_b) continue;
      refuse_run(other.folder, fmt::format("was judged with {} {}: {}, but {} with {}", what,
                                           key.substr(1), in_b.dump(), first.folder, in_a.dump()));
    }
  }
}

void require_same_making(const std::vector<AreaRun>& runs) {
  const AreaRun& first = runs.front();
  for (const AreaRun& run : runs) {
    require_same(first, run, "version", first.run.at("versions"), run.run.at("versions"));
    require_same(first, run, "option", options_of(first), options_of(run));
    require_same(first, run, "reference system", system_of(first), system_of(run));
    require_same(first, run, "input", shared_inputs_of(first), shared_inputs_of(run));
    if (run.evaluations.size() == first.evaluations.size()) continue;
    refuse_run(run.folder, "has another number of line files than " + first.folder);
  }
}

void require_disjoint(const std::vector<AreaRun>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const auto& a = runs[i].bounds;
      const auto& b = runs[k].bounds;
      const bool overlap = std::max(a[0], b[0]) < std::min(a[2], b[2]) &&
                           std::max(a[1], b[1]) < std::min(a[3], b[3]);
      if (overlap) refuse_run(runs[i].folder, "its area overlaps that of " + runs[k].folder);
    }
  }
}

/// The inputs of all runs, each file once.
std::vector<Json> inputs_of(const std::vector<AreaRun>& runs) {
  std::vector<Json> inputs;
  std::map<std::string, std::pair<std::string, std::string>> known;  // hash and folder by path
  for (const AreaRun& run : runs) {
    for (const Json& input : run.run.at("inputs")) {
      const auto path = input.at("path").get<std::string>();
      const auto hash = input.at("sha256").get<std::string>();
      const auto [entry, is_new] = known.try_emplace(path, hash, run.folder);
      if (is_new) inputs.push_back(input);
      if (entry->second.first != hash) {
        refuse_run(run.folder,
                   fmt::format("was judged with another {} than {}", path, entry->second.second));
      }
    }
  }
  return inputs;
}

/// The position of a line in the evaluations of several runs.
struct LinePlace {
  std::size_t number, run, line;
  auto operator<=>(const LinePlace&) const = default;
};

std::vector<LinePlace> places_of(const std::vector<AreaRun>& runs, std::size_t method) {
  std::vector<LinePlace> places;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const evaluate::AreaPart& area = *runs[run].evaluations[method].area;
    for (std::size_t i = 0; i < area.numbers.size(); ++i) {
      if (area.numbers[i] >= runs.front().evaluations[method].area->n_lines) {
        refuse_run(runs[run].folder,
                   fmt::format("has a line {} that its file lacks", area.numbers[i]));
      }
      places.push_back({area.numbers[i], run, i});
    }
  }
  std::ranges::sort(places);
  const auto twice = std::ranges::adjacent_find(places, {}, &LinePlace::number);
  if (twice == places.end()) return places;
  const auto next = std::next(twice);
  refuse_run(runs[next->run].folder,
             fmt::format("line {} stands there and in {}",
                         runs[next->run].evaluations[method].lines[next->line].id,
                         runs[twice->run].folder));
}

/// Gives the planes of all runs the ids that a single run of all lines would give them.
void identify_planes_of(std::vector<AreaRun>& runs, std::size_t method) {
  const std::size_t n_lines = runs.front().evaluations[method].area->n_lines;
  std::vector<evaluate::LineEvaluation*> by_number(n_lines, nullptr);
  for (AreaRun& run : runs) {
    Evaluation& evaluation = run.evaluations[method];
    for (std::size_t i = 0; i < evaluation.lines.size(); ++i) {
      by_number[evaluation.area->numbers[i]] = &evaluation.lines[i];
    }
  }
  evaluate::identify_planes(by_number);
}

/// The likely cause of the shift if all runs that state one agree; else "".
std::string common_cause(const std::vector<AreaRun>& runs, std::size_t method) {
  std::set<std::string> causes;
  for (const AreaRun& run : runs) {
    const auto& shift = run.evaluations[method].shift;
    if (shift && !shift->cause.empty()) causes.insert(shift->cause);
  }
  return causes.size() == 1 ? *causes.begin() : "";
}

void pool_shift(const std::vector<AreaRun>& runs, std::size_t method, Evaluation& pooled) {
  const double lidar_sigma_m =
      runs.front().run.at("options").at("judge").at("lidar_sigma_m").get<double>();
  pooled.shift =
      evaluate::estimate_shift(pooled.lines, std::hypot(lidar_sigma_m, pooled.options.sigma_sys_m));
  if (pooled.shift && pooled.shift->is_significant()) {
    pooled.shift->cause = common_cause(runs, method);
  }
}

void pool_decoys(std::vector<AreaRun>& runs,
                 std::size_t method,
                 const std::vector<LinePlace>& places,
                 Evaluation& pooled) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> place_of;  // by run and line
  for (std::size_t i = 0; i < places.size(); ++i) place_of[{places[i].run, places[i].line}] = i;
  std::vector<evaluate::JudgedDecoy> decoys;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (evaluate::JudgedDecoy& decoy : runs[run].evaluations[method].area->decoys) {
      decoy.decoy.parent = place_of.at({run, decoy.decoy.parent});
      decoys.push_back(std::move(decoy));
    }
  }
  const auto number = [](const evaluate::JudgedDecoy& judged) { return judged.decoy.number; };
  std::ranges::sort(decoys, {}, number);
  std::vector<evaluate::JudgedLine> lines(pooled.lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (pooled.lines[i].segment) lines[i].segment = *pooled.lines[i].segment;
  }
  add_decoys(decoys, lines, pooled);
}

void pool_completeness(const std::vector<AreaRun>& runs, std::size_t method, Evaluation& pooled) {
  std::vector<const evaluate::Completeness*> parts;
  for (const AreaRun& run : runs) {
    const auto& part = run.evaluations[method].completeness;
    if (part) parts.push_back(&*part);
  }
  if (!parts.empty()) {
    pooled.completeness = evaluate::pooled(parts, pooled.options.bootstrap);
  }
}

Evaluation pooled_evaluation(std::vector<AreaRun>& runs,
                             std::size_t method,
                             std::vector<std::string>& warnings) {
  const std::vector<LinePlace> places = places_of(runs, method);
  identify_planes_of(runs, method);
  const Evaluation& first = runs.front().evaluations[method];
  Evaluation pooled;
  pooled.patch = first.patch;
  pooled.method = first.method;
  pooled.origin_m = first.origin_m;
  pooled.options = first.options;
  for (const auto& [number, run, line] : places) {
    pooled.lines.push_back(std::move(runs[run].evaluations[method].lines[line]));
    for (evaluate::JudgingPlane& plane : pooled.lines.back().planes) plane.points = {};
  }
  if (const std::size_t n = first.area->n_lines; n > places.size()) {
    warnings.push_back(fmt::format("{}: {} of {} lines lie in none of the areas", pooled.method,
                                   n - places.size(), n));
  }
  pooled = evaluate::with_summaries(std::move(pooled));
  pool_shift(runs, method, pooled);
  const evaluate::FrameCheck check = evaluate::check_frame(pooled.lines, kFrameTolerance_m);
  if (!check.same_frame) {
    refuse_run(runs.front().folder, "lines and cloud are not in the same frame: " + check.reason);
  }
  pool_decoys(runs, method, places, pooled);
  pool_completeness(runs, method, pooled);
  check_follows_cloud(pooled, runs.front().folder, {}, warnings);
  return pooled;
}

}  // namespace

PooledRuns pool_runs(const std::vector<std::string>& folders) {
  PooledRuns pooled;
  try {
    for (const std::string& folder : folders) pooled.runs.push_back(read_run(folder));
    std::ranges::sort(pooled.runs, {}, &AreaRun::bounds);
    require_same_making(pooled.runs);
    require_disjoint(pooled.runs);
    pooled.inputs = inputs_of(pooled.runs);
    pooled.options = pooled.runs.front().run.at("options");
    pooled.options.erase("area");
    for (const AreaRun& run : pooled.runs) {
      for (const Json& warning : run.run.at("warnings")) {
        const auto text = warning.get<std::string>();
        const bool is_new = std::ranges::find(pooled.warnings, text) == pooled.warnings.end();
        if (is_new) pooled.warnings.push_back(text);
      }
    }
    const std::size_t n_methods = pooled.runs.front().evaluations.size();
    for (std::size_t method = 0; method < n_methods; ++method) {
      pooled.evaluations.push_back(pooled_evaluation(pooled.runs, method, pooled.warnings));
    }
    pooled.models = pooled_models(pooled.runs, pooled.evaluations);
  } catch (const Json::exception& error) {
    refuse_run(folders.front(), fmt::format("one of the runs is damaged: {}", error.what()));
  } catch (const std::invalid_argument& error) {
    refuse_run(folders.front(), fmt::format("one of the runs is damaged: {}", error.what()));
  }
  return pooled;
}

}  // namespace ridgeline::results
