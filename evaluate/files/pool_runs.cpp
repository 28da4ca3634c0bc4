// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/pool_runs.h"

#include "evaluate/faces/building_table.h"
#include "evaluate/faces/face_table.h"
#include "evaluate/files/finish_judging.h"
#include "evaluate/files/judge_decoys.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/files/write_results.h"
#include "evaluate/statistics/frame_check.h"
#include "evaluate/statistics/shared_planes.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/format.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "io/files/text_file.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;
using evaluate::Json;

[[noreturn]] void refuse_run(const std::string& folder, const std::string& problem) {
  throw io::IoError(folder, problem);
}

/// Table 2 does not name evaluations without lines, which an area may have: they are not found by
/// read_evaluations().
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
        "its lines were moved by the shift of their own area (apply_shift); judge it without");
  }
  run.bounds = options.at("area").get<std::array<double, 4>>();
  for (const Json& lines : options.at("lines")) {
    const std::string name = evaluation_names(stem_of(lines.get<std::string>())).front();
    run.evaluations.push_back(read_area_evaluation((fs::path(folder) / name).string()));
  }
  return run;
}

/// Options on which results depend: not the area, and no paths.
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

/// Hashes by role and name of the inputs that all runs must share: all but the cloud, of which a
/// run reads the files near its lines.
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
  }
}

void refuse_overlaps(const std::vector<AreaRun>& runs) {
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

/// A line of an evaluation of several runs.
struct LinePlace {
  std::size_t number, run, line;
  auto operator<=>(const LinePlace&) const = default;
};

std::vector<LinePlace> places_of(const std::vector<AreaRun>& runs, std::size_t method) {
  std::vector<LinePlace> places;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::vector<std::size_t>& numbers = runs[run].evaluations[method].area->numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) places.push_back({numbers[i], run, i});
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

void join_planes_of(std::vector<AreaRun>& runs, std::size_t method) {
  std::vector<std::vector<evaluate::LineEvaluation*>> lines(runs.size());
  std::vector<evaluate::JudgedRun> judged;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (auto& line : runs[run].evaluations[method].lines) lines[run].push_back(&line);
    judged.emplace_back(lines[run]);
  }
  evaluate::join_planes(judged);
}

/// What the runs that state a likely cause of their shift agree on; else nothing.
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
  std::vector<evaluate::JudgedLine> lines(pooled.lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (pooled.lines[i].segment) lines[i].segment = *pooled.lines[i].segment;
  }
  add_decoys(decoys, lines, pooled);
}

Evaluation pooled_evaluation(std::vector<AreaRun>& runs,
                             std::size_t method,
                             std::vector<std::string>& warnings) {
  const std::vector<LinePlace> places = places_of(runs, method);
  join_planes_of(runs, method);
  const Evaluation& first = runs.front().evaluations[method];
  Evaluation pooled;
  pooled.patch = first.patch;
  pooled.method = first.method;
  pooled.origin_m = first.origin_m;
  pooled.options = first.options;
  for (const auto& [number, run, line] : places) {
    pooled.lines.push_back(std::move(runs[run].evaluations[method].lines[line]));
    for (evaluate::JudgingPlane& plane : pooled.lines.back().planes) plane.sample.clear();
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
  check_follows_cloud(pooled, runs.front().folder, {}, warnings);
  return pooled;
}

/// The rows of a table of one run, read from front to back.
class Rows {
 public:
  Rows(const AreaRun& run, const char* name, std::size_t n_columns)
      : table_((fs::path(run.folder) / name).string()), n_columns_(n_columns) {}

  [[nodiscard]] bool at_end() const { return next_ == table_.size(); }
  /// The cells of the next row.
  std::vector<std::string> take() {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < n_columns_; ++c) {
      cells.emplace_back(table_.text(next_, c));
    }
    ++next_;
    return cells;
  }

 private:
  io::CsvTable table_;
  std::size_t n_columns_;
  std::size_t next_ = 0;
};

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += evaluate::escape_csv(cell) + ",";
  line.back() = '\n';
  return line;
}

std::size_t n_columns_of(const std::string& header) {
  return static_cast<std::size_t>(std::ranges::count(header, ',')) + 1;
}

/// A building of a run: its row of buildings.csv and those of faces.csv.
struct PooledBuilding {
  std::size_t number = 0;
  std::vector<std::string> by;
  std::string id, verdict, row, faces;
};

evaluate::BuildingVerdict verdict_named(const std::string& text) {
  const auto found = std::ranges::find_if(evaluate::kBuildingVerdicts, [&](const auto verdict) {
    return text == evaluate::text(verdict);
  });
  return found == evaluate::kBuildingVerdicts.end() ? evaluate::BuildingVerdict::kNotJudged
                                                    : *found;
}

void pool_by(const Evaluation& evaluation,
             const std::vector<PooledBuilding>& buildings,
             const std::vector<std::string>& columns,
             std::string& text) {
  std::vector<evaluate::RoofBuilding> without_faces(buildings.size());
  for (std::size_t b = 0; b < buildings.size(); ++b) without_faces[b].id = buildings[b].id;
  std::vector<evaluate::BuildingRow> rows = evaluate::building_table(
      without_faces, std::vector<std::vector<evaluate::FaceEvaluation>>(buildings.size()),
      std::vector<evaluate::PointDistances>(buildings.size()), evaluation.lines);
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    rows[b].verdict = verdict_named(buildings[b].verdict);
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::vector<std::string> values =
        transformed(buildings, [c](const PooledBuilding& building) { return building.by.at(c); });
    text += by_rows(evaluation.method, columns[c], rows, values);
  }
}

/// The tables of the models: rows of buildings in the order of their file, kinds added up.
ModelTables pooled_models(const std::vector<AreaRun>& runs,
                          const std::vector<Evaluation>& evaluations) {
  ModelTables pooled;
  const std::size_t n_columns = n_columns_of(evaluate::buildings_csv_header());
  const std::size_t n_face_columns = n_columns_of(evaluate::faces_csv_header());
  std::vector<std::vector<PooledBuilding>> buildings(evaluations.size());
  std::map<std::tuple<std::size_t, std::string, std::string>, int> kinds;
  for (const AreaRun& run : runs) {
    if (!fs::exists(fs::path(run.folder) / "buildings.csv")) continue;
    Rows rows(run, "buildings.csv", n_columns);
    Rows faces(run, "faces.csv", n_face_columns);
    const io::CsvTable table((fs::path(run.folder) / "buildings.csv").string());
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
      for (const evaluate::AreaBuilding& building : run.evaluations[i].area->buildings) {
        const std::vector<std::string> cells = rows.take();
        const std::size_t n_faces = std::stoul(cells[table.column("n_faces")]);
        PooledBuilding& one = buildings[i].emplace_back();
        one = {building.number,           building.by,
               cells[table.column("id")], cells[table.column("verdict")],
               csv_line(cells),           ""};
        for (std::size_t f = 0; f < n_faces; ++f) one.faces += csv_line(faces.take());
      }
    }
    for (Rows counts(run, "kinds.csv", 4); !counts.at_end();) {
      const std::vector<std::string> cells = counts.take();
      const auto method = std::ranges::find(evaluations, cells[0], &Evaluation::method);
      kinds[{static_cast<std::size_t>(method - evaluations.begin()), cells[1], cells[2]}] +=
          std::stoi(cells[3]);
    }
  }
  const auto columns = runs.front().run.at("options").at("by").get<std::vector<std::string>>();
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    std::ranges::sort(buildings[i], {}, &PooledBuilding::number);
    for (const PooledBuilding& building : buildings[i]) {
      pooled.buildings += building.row;
      pooled.faces += building.faces;
    }
    if (!buildings[i].empty()) pool_by(evaluations[i], buildings[i], columns, pooled.by);
  }
  for (const auto& [kind, n] : kinds) {
    const auto& [method, stated, in_scan] = kind;
    pooled.kinds += csv_line({evaluations[method].method, stated, in_scan, fmt::format("{}", n)});
  }
  return with_headers(std::move(pooled));
}

}  // namespace

PooledRuns pool_runs(const std::vector<std::string>& folders) {
  PooledRuns pooled;
  try {
    for (const std::string& folder : folders) pooled.runs.push_back(read_run(folder));
    std::ranges::sort(pooled.runs, {}, &AreaRun::bounds);
    require_same_making(pooled.runs);
    refuse_overlaps(pooled.runs);
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
    refuse_run(folders.front(),
               std::string("run.json of one of the runs is damaged: ") + error.what());
  }
  return pooled;
}

}  // namespace ridgeline::results
