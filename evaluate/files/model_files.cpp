// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/model_files.h"

#include "evaluate/faces/face_table.h"
#include "evaluate/judge/roof_kind.h"
#include "evaluate/statistics/distribution.h"
#include "evaluate/tables/format.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace ridgeline::results {
namespace {

/// The number of lines by stated kind and kind in the scan; a line that was not judged has the kind
/// "not judged".
std::string kinds_rows(const JudgedFiles& judged, std::size_t i) {
  evaluate::PlanesById planes;
  for (const evaluate::JudgedPlane& plane : judged.planes[i]) planes[plane.id] = &plane;
  const io::LineSet& set = judged.line_sets[i];
  const Eigen::Vector3d unit_m = unit_m_of(set);
  std::map<std::pair<std::string, std::string>, int> counts;
  for (std::size_t k = 0; k < set.lines.size(); ++k) {
    const std::string kind =
        evaluate::roof_kind(judged.evaluations[i].lines[k],
                            segment_in_local(set.lines[k], unit_m, judged.frame), planes);
    ++counts[{set.lines[k].kind, kind.empty() ? "not judged" : kind}];
  }
  std::string text;
  for (const auto& [kinds, n] : counts) {
    text += fmt::format("{},{},{},{}\n", evaluate::escape_csv(judged.evaluations[i].method),
                        kinds.first, kinds.second, n);
  }
  return text;
}

/// Totals of the buildings with the same value of an attribute.
struct Group {
  int n_buildings = 0, n_right = 0, n_judged_buildings = 0, n_lines = 0, n_judged_lines = 0;
  double squares_m2 = 0.0;
};

/// The distances of all points from their buildings; std::nullopt without points.
std::optional<std::string> points_message(const JudgedModel& model) {
  std::vector<double> to_surface_m, to_roof_m;
  for (const evaluate::PointDistances& points : model.points) {
    std::ranges::copy(points.to_surface_m, std::back_inserter(to_surface_m));
    std::ranges::copy(points.to_roof_m, std::back_inserter(to_roof_m));
  }
  if (to_surface_m.empty()) return std::nullopt;
  const std::size_t n = to_surface_m.size();
  const std::optional<double> rms_m = evaluate::rms(to_surface_m);
  std::string text = fmt::format(
      "{} points, distance from the nearest surface of their building: RMS {:.3f} m, 90 % within "
      "{:.3f} m",
      n, *rms_m, *evaluate::quantile(std::move(to_surface_m), 0.9));
  if (!to_roof_m.empty())
    text += fmt::format("; over the roofs {:.3f} m in height", *evaluate::rms(to_roof_m));
  return text;
}

/// What the model lacks; std::nullopt if it was not compared with the edges of the scan.
std::optional<std::string> lacks_message(const JudgedModel& model) {
  if (!model.missing_roofs) return std::nullopt;
  int n = 0, n_missing = 0;
  for (const evaluate::BuildingRow& row : model.rows) {
    n += row.scan_edges ? row.scan_edges->n : 0;
    n_missing += row.scan_edges ? row.scan_edges->n_missing : 0;
  }
  return fmt::format(
      "{} of {} roof edges of the scan on these buildings are missing in the model; {} roofs of 20 "
      "m2 and more lie on no building",
      n_missing, n, model.missing_roofs->size());
}

}  // namespace

std::string value_in(const io::AttributeTable& table, std::size_t row, const std::string& name) {
  if (row >= table.rows.size()) return "";
  for (const auto& [column, value] : table.rows[row])
    if (table.columns[column].name == name) return io::text_of(value);
  return "";
}

std::vector<std::string> model_names() {
  return {"buildings.csv", "faces.csv", "kinds.csv", "buildings_by.csv", "missing_roofs.csv"};
}

std::string by_rows(const std::string& method,
                    const std::string& column,
                    const std::vector<evaluate::BuildingRow>& rows,
                    const std::vector<std::string>& values) {
  std::map<std::string, Group> groups;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    const evaluate::BuildingRow& row = rows[b];
    Group& group = groups[values[b]];
    ++group.n_buildings;
    group.n_right += row.verdict == evaluate::BuildingVerdict::kRight ? 1 : 0;
    group.n_judged_buildings += row.verdict != evaluate::BuildingVerdict::kNotJudged ? 1 : 0;
    group.n_lines += row.n_lines;
    group.n_judged_lines += row.n_judged_lines;
    group.squares_m2 += row.n_judged_lines * row.rms_m.value_or(0.0) * row.rms_m.value_or(0.0);
  }
  std::string text;
  for (const auto& [value, group] : groups) {
    std::optional<double> rms_m;
    if (group.n_judged_lines > 0) rms_m = std::sqrt(group.squares_m2 / group.n_judged_lines);
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", evaluate::escape_csv(method),
                        evaluate::escape_csv(column), evaluate::escape_csv(value),
                        group.n_buildings, group.n_judged_buildings, group.n_right, group.n_lines,
                        group.n_judged_lines, evaluate::fixed(rms_m, 4, ""));
  }
  return text;
}

std::string missing_roof_rows(const std::string& method, std::vector<MissingRoofRow> roofs) {
  std::ranges::stable_sort(roofs, [](const MissingRoofRow& a, const MissingRoofRow& b) {
    return std::tuple(-a.area_m2, a.middle.x(), a.middle.y()) <
           std::tuple(-b.area_m2, b.middle.x(), b.middle.y());
  });
  std::string text;
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    const Eigen::Vector3d& x = roofs[i].middle;
    text += fmt::format("{},{},{:.2f},{:.4f},{:.3f},{:.3f},{:.3f}\n", evaluate::escape_csv(method),
                        i + 1, roofs[i].area_m2, roofs[i].explained, x.x(), x.y(), x.z());
  }
  return text;
}

ModelTables with_headers(ModelTables rows) {
  if (rows.buildings.empty()) return {};
  rows.buildings.insert(0, evaluate::buildings_csv_header(rows.with_scan_edges));
  rows.faces.insert(0, evaluate::faces_csv_header());
  rows.kinds.insert(0, "method,stated_kind,scan_kind,n_lines\n");
  if (rows.with_scan_edges)
    rows.missing_roofs.insert(0, "method,id,area_m2,explained_share,x,y,z\n");
  if (!rows.by.empty())
    rows.by.insert(0,
                   "method,column,value,n_buildings,n_judged_buildings,n_right,n_lines,"
                   "n_judged_lines,rms_m\n");
  return rows;
}

ModelTables model_tables(const JudgedFiles& judged, const std::vector<std::string>& by) {
  ModelTables tables;
  for (std::size_t i = 0; i < judged.models.size(); ++i) {
    if (!judged.models[i]) continue;
    const JudgedModel& model = *judged.models[i];
    const std::string& method = judged.evaluations[i].method;
    tables.buildings += evaluate::buildings_csv_rows(method, model.rows);
    tables.faces += evaluate::faces_csv_rows(method, model.buildings, model.faces);
    tables.kinds += kinds_rows(judged, i);
    if (model.missing_roofs) {
      tables.with_scan_edges = true;
      tables.missing_roofs +=
          missing_roof_rows(method, transformed(*model.missing_roofs, [&](const MissingRoof& roof) {
                              const Eigen::Vector3d middle_m = roof.middle + judged.frame.origin_m;
                              return MissingRoofRow{roof.area_m2, roof.explained,
                                                    middle_m.cwiseQuotient(judged.cloud_unit_m)};
                            }));
    }
    for (const std::string& column : by) {
      const std::vector<std::string> values = transformed(model.places, [&](std::size_t place) {
        return value_in(judged.line_sets[i].features, place, column);
      });
      tables.by += by_rows(method, column, model.rows, values);
    }
  }
  return with_headers(std::move(tables));
}

void write_models(const ModelTables& tables, const OutputFolder& out) {
  const std::vector<std::string> names = model_names();
  const std::array texts{&tables.buildings, &tables.faces, &tables.kinds, &tables.by,
                         &tables.missing_roofs};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (texts[i]->empty())
      out.remove(names[i]);
    else
      out.write(names[i], *texts[i]);
  }
}

std::vector<std::string> model_messages(const JudgedFiles& judged) {
  std::vector<std::string> messages;
  for (std::size_t i = 0; i < judged.models.size(); ++i) {
    if (!judged.models[i]) continue;
    std::map<evaluate::BuildingVerdict, std::size_t> counts;
    for (const evaluate::BuildingRow& row : judged.models[i]->rows) ++counts[row.verdict];
    std::string text = fmt::format("{}: {} buildings", judged.evaluations[i].method,
                                   judged.models[i]->rows.size());
    const char* separator = ": ";
    for (const evaluate::BuildingVerdict verdict : evaluate::kBuildingVerdicts) {
      if (counts[verdict] == 0) continue;
      text += fmt::format("{}{} {}", std::exchange(separator, ", "), counts[verdict],
                          evaluate::text(verdict));
    }
    messages.push_back(std::move(text));
    if (const auto points = points_message(*judged.models[i])) messages.push_back(*points);
    if (const auto lacks = lacks_message(*judged.models[i])) messages.push_back(*lacks);
  }
  return messages;
}

}  // namespace ridgeline::results
