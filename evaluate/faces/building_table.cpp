// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/building_table.h"

#include "evaluate/tables/format.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <map>

namespace ridgeline::evaluate {
namespace {

void add_line(const LineEvaluation& line, BuildingRow& row) {
  ++row.n_lines;
  if (line.status != Status::kEvaluated) return;
  ++row.n_judged_lines;
  // the mean of the squares, from one line to the next
  const double before = row.rms_m.value_or(0.0);
  const double distance_m = *line.mean_distance_m;
  const double square = distance_m * distance_m;
  row.rms_m = std::sqrt(before * before + (square - before * before) / row.n_judged_lines);
  if (!row.worst_distance_m || distance_m > *row.worst_distance_m) {
    row.worst_distance_m = distance_m;
    row.worst_line = line.id;
  }
}

/// What the faces of a building add up to.
struct FaceSums {
  double height_m2 = 0.0, tilt_m2 = 0.0, outline_m2 = 0.0;
  int n_over = 0, n_unexplained = 0;
};

void add_face(const FaceEvaluation& face, BuildingRow& row, FaceSums& sums) {
  ++row.n_faces;
  if (face.status == FaceStatus::kSteep) return;
  row.area_m2 += face.area_m2;
  if (face.status == FaceStatus::kEvaluated) ++row.n_judged_faces;
  if (face.status != FaceStatus::kEvaluated && face.status != FaceStatus::kNoPlane) return;
  row.judged_area_m2 += face.area_m2;
  sums.n_over += face.n_over;
  sums.n_unexplained += face.n_unexplained;
  sums.height_m2 += face.verdict.height ? face.area_m2 : 0.0;
  sums.tilt_m2 += face.verdict.tilt ? face.area_m2 : 0.0;
  sums.outline_m2 += face.verdict.outline ? face.area_m2 : 0.0;
}

void set_shares(const FaceSums& sums, BuildingRow& row) {
  if (row.judged_area_m2 > 0.0) {
    row.wrong_height = sums.height_m2 / row.judged_area_m2;
    row.wrong_tilt = sums.tilt_m2 / row.judged_area_m2;
    row.wrong_outline = sums.outline_m2 / row.judged_area_m2;
  }
  if (sums.n_over > 0) row.unexplained = static_cast<double>(sums.n_unexplained) / sums.n_over;
}

BuildingVerdict verdict_of(const BuildingRow& row, const FaceOptions& options) {
  constexpr double kLeastJudged = 0.5;  // of the area
  if (!row.unexplained || row.judged_area_m2 < kLeastJudged * row.area_m2) {
    return BuildingVerdict::kNotJudged;
  }
  if (*row.unexplained > options.max_unexplained) return BuildingVerdict::kFacesMissing;
  BuildingVerdict verdict = BuildingVerdict::kRight;
  double largest = options.max_wrong_share;
  const auto consider = [&](double share, BuildingVerdict what) {
    if (share > largest) largest = share, verdict = what;
  };
  consider(row.wrong_height, BuildingVerdict::kWrongHeight);
  consider(row.wrong_tilt, BuildingVerdict::kWrongTilt);
  consider(row.wrong_outline, BuildingVerdict::kWrongOutline);
  return verdict;
}

std::string csv_row(const std::string& method, const BuildingRow& row) {
  const auto figure = [](std::optional<double> value) { return fixed(value, 4, ""); };
  const auto area = [](double value_m2) { return fixed(value_m2, 1, ""); };
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(method),
                     escape_csv(row.id), text(row.verdict), row.n_lines, row.n_judged_lines,
                     figure(row.rms_m), escape_csv(row.worst_line), figure(row.worst_distance_m),
                     row.n_faces, row.n_judged_faces, area(row.area_m2), area(row.judged_area_m2),
                     figure(row.wrong_height), figure(row.wrong_tilt), figure(row.wrong_outline),
                     figure(row.heights.ridge_m), figure(row.heights.eave_m),
                     figure(row.unexplained));
}

}  // namespace

const char* text(BuildingVerdict verdict) {
  switch (verdict) {
    case BuildingVerdict::kRight:
      return "right";
    case BuildingVerdict::kWrongHeight:
      return "wrong height";
    case BuildingVerdict::kWrongTilt:
      return "wrong tilt";
    case BuildingVerdict::kWrongOutline:
      return "wrong outline";
    case BuildingVerdict::kFacesMissing:
      return "faces missing";
    case BuildingVerdict::kNotJudged:
      break;
  }
  return "not judged";
}

std::vector<BuildingRow> building_table(std::span<const RoofBuilding> buildings,
                                        std::span<const std::vector<FaceEvaluation>> evaluations,
                                        std::span<const LineEvaluation> lines,
                                        const FaceOptions& options) {
  check(buildings.size() == evaluations.size(), "building_table: evaluations of ",
        evaluations.size(), " buildings, must be those of ", buildings.size());
  std::map<std::string, std::vector<const LineEvaluation*>> lines_of;
  for (const LineEvaluation& line : lines) lines_of[line.building].push_back(&line);
  std::vector<BuildingRow> rows;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    check(buildings[b].faces.size() == evaluations[b].size(),
          "building_table: ", evaluations[b].size(), " evaluations of building ", buildings[b].id,
          ", must be ", buildings[b].faces.size());
    BuildingRow row;
    row.id = buildings[b].id;
    for (const LineEvaluation* line : lines_of[row.id]) add_line(*line, row);
    FaceSums sums;
    for (const FaceEvaluation& face : evaluations[b]) add_face(face, row, sums);
    set_shares(sums, row);
    row.heights = edge_heights(buildings[b].faces, evaluations[b]);
    row.verdict = verdict_of(row, options);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string buildings_csv_header() {
  return "method,id,verdict,n_lines,n_judged_lines,rms_m,worst_line,worst_distance_m,n_faces,n_"
         "judged_faces,"
         "area_m2,judged_area_m2,wrong_height_share,wrong_tilt_share,wrong_outline_share,"
         "ridge_height_m,eave_height_m,unexplained_share\n";
}

std::string buildings_csv_rows(const std::string& method, std::span<const BuildingRow> rows) {
  std::string text;
  for (const BuildingRow& row : rows) text += csv_row(method, row);
  return text;
}

}  // namespace ridgeline::evaluate
