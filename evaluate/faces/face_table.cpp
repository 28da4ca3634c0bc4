// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_table.h"

#include "evaluate/tables/format.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace ridgeline::evaluate {
namespace {

std::string cell(std::optional<double> value) { return fixed(value, 4, ""); }
std::string area_cell(double value_m2) { return fixed(value_m2, 1, ""); }

/// An estimate and its half width.
std::string cells(const std::optional<Estimate>& estimate) {
  if (!estimate) return ",";
  return cell(estimate->value) + "," + cell(estimate->half_width);
}

std::optional<double> largest_offset_m(const FaceEvaluation& face) {
  std::optional<double> largest;
  for (const EdgeOffset& edge : face.edges) {
    if (!largest || std::abs(edge.offset_m) > std::abs(*largest)) largest = edge.offset_m;
  }
  return largest;
}

/// All columns from n_on_plane onwards.
std::string figures(const FaceEvaluation& face) {
  if (face.status != FaceStatus::kEvaluated) return std::string(17, ',');  // one comma before each
  const PlaneDifference& d = face.difference;
  return fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{}", face.fit.n, cell(face.fit.rms_m),
                     cells(d.shift_m), cells(d.height_m), cells(d.angle_deg), cells(d.pitch_deg),
                     cells(d.aspect_deg), cell(face.share_on_plane), cell(face.covered_share),
                     area_cell(face.beyond_m2), area_cell(face.missing_m2),
                     cell(largest_offset_m(face)));
}

std::string row(const std::string& building,
                const RoofFace& face,
                const FaceEvaluation& evaluation) {
  const auto of_plane = [&](double value) { return face.degenerate ? std::string() : cell(value); };
  const bool is_judged = evaluation.status == FaceStatus::kEvaluated;
  return fmt::format("{},{},{},{},{},{},{},{}{}\n", escape_csv(building), escape_csv(face.id),
                     name(evaluation.status), is_judged ? text(evaluation.verdict) : "",
                     area_cell(evaluation.area_m2), of_plane(slope_rad(face.plane) / kRadPerDeg),
                     of_plane(face.flatness_m), evaluation.n_over, figures(evaluation));
}

}  // namespace

std::string faces_csv_header() {
  return "method,building,face,status,verdict,area_m2,slope_deg,flatness_m,n_over,n_on_plane,rms_m,"
         "shift_m,shift_95_m,height_m,height_95_m,angle_deg,angle_95_deg,pitch_deg,pitch_95_deg,"
         "aspect_deg,aspect_95_deg,share_on_plane,covered_share,beyond_m2,missing_m2,"
         "largest_offset_m\n";
}

std::string faces_csv_rows(const std::string& method,
                           std::span<const RoofBuilding> buildings,
                           std::span<const std::vector<FaceEvaluation>> evaluations) {
  check(buildings.size() == evaluations.size(), "faces_csv_rows: evaluations of ",
        evaluations.size(), " buildings, must be those of ", buildings.size());
  std::string text;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const std::vector<RoofFace>& faces = buildings[b].faces;
    check(faces.size() == evaluations[b].size(), "faces_csv_rows: ", evaluations[b].size(),
          " evaluations of building ", buildings[b].id, ", must be ", faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      text += escape_csv(method) + "," + row(buildings[b].id, faces[f], evaluations[b][f]);
    }
  }
  return text;
}

}  // namespace ridgeline::evaluate
