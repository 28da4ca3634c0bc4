// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/pool_models.h"

#include "evaluate/faces/building_table.h"
#include "evaluate/faces/face_table.h"
#include "evaluate/tables/format.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;

/// The rows of a table of one run, read in order. Throws IoError for a missing row.
class Rows {
 public:
  Rows(const AreaRun& run, const char* name, std::size_t n_columns)
      : path_((fs::path(run.folder) / name).string()), table_(path_), n_columns_(n_columns) {}

  [[nodiscard]] bool at_end() const { return next_ == table_.size(); }
  /// Cells of the next row.
  [[nodiscard]] std::string text(const char* column) const {
    return std::string(table_.text(row(), table_.column(column)));
  }
  [[nodiscard]] double number(const char* column) const {
    return table_.number(row(), table_.column(column));
  }
  /// Returns all cells of the next row and advances to the row after it.
  std::vector<std::string> take() {
    std::vector<std::string> cells(n_columns_);
    for (std::size_t c = 0; c < n_columns_; ++c) cells[c] = table_.text(row(), c);
    ++next_;
    return cells;
  }
  [[noreturn]] void refuse(const std::string& problem) const { throw io::IoError(path_, problem); }

 private:
  [[nodiscard]] std::size_t row() const {
    if (at_end()) refuse("has fewer rows than its run judged; judge the area again");
    return next_;
  }

  std::string path_;
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

/// A building of a run: its row in buildings.csv and its rows in faces.csv.
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

using Buildings = std::vector<PooledBuilding>;

bool has_completeness(const AreaRun& run) {
  return run.run.at("options").value("completeness", false);
}

/// Adds the buildings of a run to the lists by line file.
void add_buildings(const AreaRun& run, std::vector<Buildings>& buildings) {
  const bool with_scan_edges = has_completeness(run);
  Rows rows(run, "buildings.csv", n_columns_of(evaluate::buildings_csv_header(with_scan_edges)));
  Rows faces(run, "faces.csv", n_columns_of(evaluate::faces_csv_header()));
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    for (const evaluate::AreaBuilding& building : run.evaluations[i].area->buildings) {
      const auto n_faces = static_cast<std::size_t>(rows.number("n_faces"));
      const std::string id = rows.text("id"), verdict = rows.text("verdict");
      PooledBuilding& one = buildings[i].emplace_back();
      one = {building.number, building.by, id, verdict, csv_line(rows.take()), ""};
      for (std::size_t f = 0; f < n_faces; ++f) one.faces += csv_line(faces.take());
    }
  }
}

/// Numbers of edges by line file, kind stated by the model and kind in the scan.
using Kinds = std::map<std::tuple<std::size_t, std::string, std::string>, int>;

void add_kinds(const AreaRun& run, const std::vector<Evaluation>& evaluations, Kinds& kinds) {
  for (Rows rows(run, "kinds.csv", 4); !rows.at_end();) {
    const int n = static_cast<int>(rows.number("n_lines"));
    const std::vector<std::string> cells = rows.take();
    const auto method = std::ranges::find(evaluations, cells[0], &Evaluation::method);
    if (method == evaluations.end()) rows.refuse("names another method: " + cells[0]);
    kinds[{static_cast<std::size_t>(method - evaluations.begin()), cells[1], cells[2]}] += n;
  }
}

/// Missing roofs by method.
using MissingRoofs = std::map<std::string, std::vector<MissingRoofRow>>;

void add_missing_roofs(const AreaRun& run, MissingRoofs& missing) {
  constexpr std::size_t kColumns = 7;
  for (Rows rows(run, "missing_roofs.csv", kColumns); !rows.at_end();) {
    MissingRoofRow row{rows.number("area_m2"),
                       rows.number("explained_share"),
                       {rows.number("x"), rows.number("y"), rows.number("z")}};
    missing[rows.take().front()].push_back(std::move(row));
  }
}

}  // namespace

ModelTables pooled_models(const std::vector<AreaRun>& runs,
                          const std::vector<Evaluation>& evaluations) {
  std::vector<Buildings> buildings(evaluations.size());
  Kinds kinds;
  MissingRoofs missing;
  for (const AreaRun& run : runs) {
    if (!fs::exists(fs::path(run.folder) / "buildings.csv")) continue;
    add_buildings(run, buildings);
    add_kinds(run, evaluations, kinds);
    if (has_completeness(run)) add_missing_roofs(run, missing);
  }
  const auto columns = runs.front().run.at("options").at("by").get<std::vector<std::string>>();
  ModelTables pooled;
  pooled.with_scan_edges = has_completeness(runs.front());
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    std::ranges::sort(buildings[i], {}, &PooledBuilding::number);
    for (const PooledBuilding& building : buildings[i]) {
      pooled.buildings += building.row;
      pooled.faces += building.faces;
    }
    pooled.missing_roofs +=
        missing_roof_rows(evaluations[i].method, std::move(missing[evaluations[i].method]));
    if (!buildings[i].empty()) pool_by(evaluations[i], buildings[i], columns, pooled.by);
  }
  for (const auto& [kind, n] : kinds) {
    const auto& [method, stated, in_scan] = kind;
    pooled.kinds += csv_line({evaluations[method].method, stated, in_scan, fmt::format("{}", n)});
  }
  return with_headers(std::move(pooled));
}

}  // namespace ridgeline::results
