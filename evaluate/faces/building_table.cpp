// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/building_table.h"

#include "evaluate/faces/limits.h"
#include "evaluate/faces/whole_shift.h"
#include "evaluate/statistics/distribution.h"
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
  // running mean of the squares
  const double before = row.rms_m.value_or(0.0);
  const double distance_m = *line.mean_distance_m;
  const double square = distance_m * distance_m;
  row.rms_m = std::sqrt(before * before + (square - before * before) / row.n_judged_lines);
  if (!row.worst_distance_m || distance_m > *row.worst_distance_m) {
    row.worst_distance_m = distance_m;
    row.worst_line = line.id;
  }
}

/// Sums over the faces of a building.
struct FaceSums {
  double height_m2 = 0.0, tilt_m2 = 0.0, outline_m2 = 0.0, covered_m2 = 0.0;
  int n_over = 0, n_unexplained = 0;
};

void add_face(const FaceEvaluation& face, BuildingRow& row, FaceSums& sums) {
  ++row.n_faces;
  if (face.status == FaceStatus::kSteep) return;
  row.area_m2 += face.area_m2;
  if (face.status != FaceStatus::kEvaluated && face.status != FaceStatus::kNoPlane) return;
  ++row.n_judged_faces;
  row.judged_area_m2 += face.area_m2;
  sums.n_over += face.n_over;
  sums.n_unexplained += face.n_unexplained;
  sums.covered_m2 += face.covered_share * face.area_m2;
  sums.height_m2 += face.verdict.height ? face.area_m2 : 0.0;
  sums.tilt_m2 += face.verdict.tilt ? face.area_m2 : 0.0;
  sums.outline_m2 += face.verdict.outline ? face.area_m2 : 0.0;
}

void set_shares(const FaceSums& sums, BuildingRow& row) {
  if (row.area_m2 > 0.0) row.covered = sums.covered_m2 / row.area_m2;
  if (row.judged_area_m2 > 0.0) {
    row.wrong_height = sums.height_m2 / row.judged_area_m2;
    row.wrong_tilt = sums.tilt_m2 / row.judged_area_m2;
    row.wrong_outline = sums.outline_m2 / row.judged_area_m2;
  }
  if (sums.n_over > 0) row.unexplained = static_cast<double>(sums.n_unexplained) / sums.n_over;
}

void set_points(const PointDistances& points, BuildingRow& row) {
  row.n_points = points.to_surface_m.size();
  row.points_rms_m = rms(points.to_surface_m);
  row.points_p90_m = quantile(points.to_surface_m, 0.9);
  row.roof_points_rms_m = rms(points.to_roof_m);
}

bool is_gone(const PointDistances& points) {
  constexpr double kMaxShareBelow = 0.75;
  constexpr double kStorey_m = 1.5;  // a surface higher above the ground is not ground
  const bool is_low = !points.above_ground_m || *points.above_ground_m < kStorey_m;
  return is_low && points.n_far_below > kMaxShareBelow * points.n_over;
}

/// The verdict based on the individual faces of a building.
BuildingVerdict verdict_of_parts(const BuildingRow& row) {
  constexpr double kMinJudgedShare = 0.5;  // of the area
  if (!row.unexplained || row.judged_area_m2 < kMinJudgedShare * row.area_m2) {
    return BuildingVerdict::kNotJudged;
  }
  if (*row.unexplained > kMaxUnexplained) return BuildingVerdict::kChanged;
  BuildingVerdict verdict = BuildingVerdict::kRight;
  double largest = kMaxWrongShare;
  const auto consider = [&](double share, BuildingVerdict what) {
    if (share > largest) largest = share, verdict = what;
  };
  consider(row.wrong_height, BuildingVerdict::kWrongHeight);
  consider(row.wrong_tilt, BuildingVerdict::kWrongTilt);
  consider(row.wrong_outline, BuildingVerdict::kWrongOutline);
  const bool contradicted = row.rms_m && *row.rms_m > kOutlineTolerance_m;
  if (verdict == BuildingVerdict::kRight && contradicted) return BuildingVerdict::kNotJudged;
  return verdict;
}

/// The verdict if a shift is the only error; empty if it is within the tolerances.
std::optional<BuildingVerdict> verdict_of_shift(const Eigen::Vector3d& shift_m) {
  if (shift_m.head<2>().norm() > kOutlineTolerance_m) return BuildingVerdict::kShifted;
  if (shift_m.z() > kHeightTolerance_m) return BuildingVerdict::kTooHigh;
  if (shift_m.z() < -kHeightTolerance_m) return BuildingVerdict::kTooLow;
  return std::nullopt;
}

void set_verdict(const RoofBuilding& building,
                 std::span<const FaceEvaluation> evaluations,
                 const PointDistances& points,
                 BuildingRow& row) {
  row.verdict = verdict_of_parts(row);
  if (row.verdict == BuildingVerdict::kRight || row.verdict == BuildingVerdict::kNotJudged) return;
  if (row.verdict == BuildingVerdict::kChanged) {
    if (is_gone(points)) {
      row.verdict = BuildingVerdict::kGone;
    } else if (points.parallel_below_m &&  // beyond the range in which planes of faces are sought
               std::abs(*points.parallel_below_m) > kMaxFaceHeight_m) {
      row.shift_m = Eigen::Vector3d(0.0, 0.0, *points.parallel_below_m);
      row.verdict =
          *points.parallel_below_m > 0.0 ? BuildingVerdict::kTooHigh : BuildingVerdict::kTooLow;
    }
    return;
  }
  const auto shift_m = whole_shift_m(building.faces, evaluations);
  const auto verdict = shift_m ? verdict_of_shift(*shift_m) : std::nullopt;
  if (!verdict) return;
  row.verdict = *verdict;
  row.shift_m = shift_m;
}

std::string csv_row(const std::string& method, const BuildingRow& row) {
  const auto figure = [](std::optional<double> value) { return fixed(value, 4, ""); };
  const auto area = [](double value_m2) { return fixed(value_m2, 1, ""); };
  const auto shift = [&](int axis) {
    return figure(row.shift_m ? std::optional((*row.shift_m)[axis]) : std::nullopt);
  };
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n",
      escape_csv(method), escape_csv(row.id), text(row.verdict), row.n_lines, row.n_judged_lines,
      figure(row.rms_m), escape_csv(row.worst_line), figure(row.worst_distance_m), row.n_faces,
      row.n_judged_faces, area(row.area_m2), area(row.judged_area_m2), figure(row.wrong_height),
      figure(row.wrong_tilt), figure(row.wrong_outline), figure(row.heights.ridge_m),
      figure(row.heights.eave_m), figure(row.unexplained), shift(0), shift(1), shift(2),
      row.n_points, figure(row.points_rms_m), figure(row.points_p90_m),
      figure(row.roof_points_rms_m), figure(row.covered),
      row.scan_edges ? fmt::format(",{},{}", row.scan_edges->n, row.scan_edges->n_missing) : "");
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
    case BuildingVerdict::kShifted:
      return "shifted";
    case BuildingVerdict::kTooHigh:
      return "too high";
    case BuildingVerdict::kTooLow:
      return "too low";
    case BuildingVerdict::kChanged:
      return "changed";
    case BuildingVerdict::kGone:
      return "gone";
    case BuildingVerdict::kNotJudged:
      break;
  }
  return "not judged";
}

std::vector<BuildingRow> building_table(std::span<const RoofBuilding> buildings,
                                        std::span<const std::vector<FaceEvaluation>> evaluations,
                                        std::span<const PointDistances> points,
                                        std::span<const LineEvaluation> lines) {
  check(buildings.size() == evaluations.size(), "building_table: evaluations of ",
        evaluations.size(), " buildings, must be those of ", buildings.size());
  check(buildings.size() == points.size(), "building_table: points of ", points.size(),
        " buildings, must be those of ", buildings.size());
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
    set_points(points[b], row);
    set_verdict(buildings[b], evaluations[b], points[b], row);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string buildings_csv_header(bool with_scan_edges) {
  const char* more = with_scan_edges ? ",n_scan_edges,n_missing_edges" : "";
  return fmt::format(
      "method,id,verdict,n_lines,n_judged_lines,rms_m,worst_line,worst_distance_m,n_faces,n_judged_"
      "faces,area_m2,judged_area_m2,wrong_height_share,wrong_tilt_share,wrong_outline_share,ridge_"
      "height_m,eave_height_m,unexplained_share,shift_x_m,shift_y_m,shift_z_m,n_points,points_rms_"
      "m,points_p90_m,roof_points_rms_m,covered_share{}\n",
      more);
}

std::string buildings_csv_rows(const std::string& method, std::span<const BuildingRow> rows) {
  std::string text;
  for (const BuildingRow& row : rows) text += csv_row(method, row);
  return text;
}

}  // namespace ridgeline::evaluate
