// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/to_fix.h"

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/map_style.h"
#include "evaluate/judge/ridge_displacement.h"
#include "evaluate/judge/roof_kind.h"
#include "evaluate/tables/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::BuildingVerdict;
using evaluate::LineEvaluation;

constexpr double kWrong_m =
    0.3;  ///< a line that is farther off counts as wrong in docs/accuracy.md

double squared(double x) { return x * x; }

double squares_m2(const std::vector<double>& x_m) {
  return std::transform_reduce(x_m.begin(), x_m.end(), 0.0, std::plus<>(), squared);
}

/// The mean of all vertices of a building's faces.
Eigen::Vector3d middle_of(const evaluate::RoofBuilding& building) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double n = 0.0;
  for (const evaluate::RoofFace& face : building.faces) {
    for (const auto& ring : face.rings) {
      for (const Eigen::Vector3d& x : ring) sum += x;
      n += static_cast<double>(ring.size());
    }
  }
  return n > 0.0 ? Eigen::Vector3d(sum / n) : sum;
}

/// The sum of squared heights between a building's roof and the points over it. Ground points are
/// only included if the roof is misplaced, because they may then in fact belong to the roof.
double roof_squares_m2(const evaluate::BuildingRow& row, const evaluate::PointDistances& points) {
  const bool is_elsewhere = row.verdict == BuildingVerdict::kGone ||
                            row.verdict == BuildingVerdict::kTooHigh ||
                            row.verdict == BuildingVerdict::kTooLow;
  return is_elsewhere ? points.over_squares_m2 : squares_m2(points.to_roof_m);
}

std::vector<ToFix> buildings_to_fix(const JudgedModel& model) {
  double all_m2 = 0.0;
  for (std::size_t b = 0; b < model.rows.size(); ++b)
    all_m2 += roof_squares_m2(model.rows[b], model.points[b]);
  std::vector<ToFix> list;
  for (std::size_t b = 0; b < model.rows.size(); ++b) {
    const evaluate::BuildingRow& row = model.rows[b];
    if (row.verdict == BuildingVerdict::kRight || row.verdict == BuildingVerdict::kNotJudged)
      continue;
    ToFix& entry = list.emplace_back();
    entry.is_building = true;
    entry.id = row.id;
    entry.kind = evaluate::text(row.verdict);
    const double squares = roof_squares_m2(row, model.points[b]);
    if (all_m2 > 0.0) entry.gain = squares / all_m2;
    entry.off_m = row.roof_points_rms_m;
    if (!entry.off_m && model.points[b].n_over > 0)
      entry.off_m = std::sqrt(squares / model.points[b].n_over);
    entry.place = middle_of(model.buildings[b]);
    if (!row.shift_m) continue;
    entry.move_x_m = -row.shift_m->x();
    entry.move_y_m = -row.shift_m->y();
    entry.move_z_m = -row.shift_m->z();
  }
  return list;
}

void set_move(const LineEvaluation& line, const Segment3& segment, ToFix& entry) {
  if (line.displacement) {
    const Eigen::Vector3d across = evaluate::across_in_plan(segment);
    entry.move_x_m = -line.displacement->horizontal_m * across.x();
    entry.move_y_m = -line.displacement->horizontal_m * across.y();
    entry.move_z_m = -line.displacement->vertical_m;
  } else if (line.height_if_vertical_m) {
    entry.move_z_m = -*line.height_if_vertical_m;
  }
}

std::vector<ToFix> lines_to_fix(const JudgedFiles& judged,
                                std::size_t i,
                                const std::set<std::string>& wrong_buildings) {
  const evaluate::Evaluation& evaluation = judged.evaluations[i];
  const double wrong_m = std::min(kWrong_m, evaluation.options.gross_m);
  evaluate::PlanesById planes;
  for (const evaluate::JudgedPlane& plane : judged.planes[i]) planes[plane.id] = &plane;
  double all_m2 = 0.0;
  for (const LineEvaluation& line : evaluation.lines)
    all_m2 += squared(line.mean_distance_m.value_or(0.0));
  std::vector<ToFix> list;
  for (const LineEvaluation& line : evaluation.lines) {
    const bool is_wrong = line.mean_distance_m && *line.mean_distance_m > wrong_m && line.segment;
    if (!is_wrong || wrong_buildings.contains(line.building)) continue;
    ToFix& entry = list.emplace_back();
    entry.id = line.id;
    entry.building = line.building;
    entry.kind = evaluate::roof_kind(line, *line.segment, planes);
    entry.gain = squared(*line.mean_distance_m) / all_m2;
    entry.off_m = *line.mean_distance_m;
    entry.place = midpoint(*line.segment);
    set_move(line, *line.segment, entry);
  }
  return list;
}

/// An entry with its 1-based position in the list.
struct Ranked {
  const ToFix& entry;
  std::int64_t rank;
};

using RankedField = MapField<Ranked>;

const std::vector<RankedField>& fields() {
  using io::ColumnType;
  static const std::vector<RankedField> all{
      {"rank", ColumnType::kInteger, [](const auto& r) { return integer(r.rank); }},
      {"what", ColumnType::kText,
       [](const auto& r) { return text(r.entry.is_building ? "building" : "line"); }},
      {"id", ColumnType::kText, [](const auto& r) { return text(r.entry.id); }},
      {"building", ColumnType::kText, [](const auto& r) { return text(r.entry.building); }},
      {"kind", ColumnType::kText, [](const auto& r) { return text(r.entry.kind); }},
      {"gain_share", ColumnType::kReal, [](const auto& r) { return number(r.entry.gain); }},
      {"off_m", ColumnType::kReal, [](const auto& r) { return number(r.entry.off_m); }},
      {"move_x_m", ColumnType::kReal, [](const auto& r) { return number(r.entry.move_x_m); }},
      {"move_y_m", ColumnType::kReal, [](const auto& r) { return number(r.entry.move_y_m); }},
      {"move_z_m", ColumnType::kReal, [](const auto& r) { return number(r.entry.move_z_m); }}};
  return all;
}

std::string csv_text(const io::Value& value) {
  if (const auto* const n = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *n);
  if (const auto* const x = std::get_if<double>(&value)) return evaluate::fixed(*x, 4);
  if (const auto* const words = std::get_if<std::string>(&value))
    return evaluate::escape_csv(*words);
  return "";
}

}  // namespace

std::vector<ToFix> to_fix(const JudgedFiles& judged, std::size_t i) {
  std::vector<ToFix> list;
  std::set<std::string> wrong_buildings;
  if (i < judged.models.size() && judged.models[i]) {
    list = buildings_to_fix(*judged.models[i]);
    for (const ToFix& building : list) wrong_buildings.insert(building.id);
  }
  std::ranges::move(lines_to_fix(judged, i, wrong_buildings), std::back_inserter(list));
  std::ranges::stable_sort(list, std::greater<>(), &ToFix::gain);
  return list;
}

std::string to_fix_csv(const JudgedFiles& judged, const std::vector<std::vector<ToFix>>& lists) {
  std::string text = "method";
  for (const RankedField& field : fields()) text += fmt::format(",{}", field.name);
  text += "\n";
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (std::size_t k = 0; k < lists[i].size(); ++k) {
      text += evaluate::escape_csv(judged.evaluations[i].method);
      const Ranked ranked{lists[i][k], static_cast<std::int64_t>(k) + 1};
      for (const RankedField& field : fields()) text += "," + csv_text(field.value(ranked));
      text += "\n";
    }
  }
  return text;
}

io::MapLayer to_fix_layer(const std::vector<ToFix>& list, const ToMap& to_map) {
  io::MapLayer layer{
      .name = "to_fix",
      .description = "What to fix first: wrong lines and buildings by the gain of correcting them",
      .geometry = io::MapGeometry::kPoint,
      .columns = columns_of(fields()),
      .features = {},
      .style = to_fix_style()};
  for (std::size_t k = 0; k < list.size(); ++k) {
    io::MapFeature& feature = layer.features.emplace_back();
    feature.vertices = {to_map(list[k].place)};
    add_values(fields(), 0, feature.values, Ranked{list[k], static_cast<std::int64_t>(k) + 1});
  }
  return layer;
}

}  // namespace ridgeline::results
