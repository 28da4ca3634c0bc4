// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_table.h"

#include "evaluate/tables/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ridgeline::evaluate {
namespace {

std::string figure(std::optional<double> value) { return fixed(value, 4, ""); }

/// The value and the half width of its interval.
std::string cells(const std::optional<Estimate>& estimate) {
  if (!estimate) return ",";
  return figure(estimate->value) + "," + figure(estimate->half_width);
}

std::string largest_offset(const FaceEvaluation& face) {
  const auto largest = std::ranges::max_element(
      face.edges, {}, [](const EdgeOffset& edge) { return std::abs(edge.offset_m); });
  return largest == face.edges.end() ? "" : figure(largest->offset_m);
}

std::string row_of(const std::string& method,
                   const std::string& building,
                   const FaceEvaluation& face) {
  std::string row = fmt::format("{},{},{},{},", escape_csv(method), escape_csv(building),
                                escape_csv(face.id), name(face.status));
  if (face.status != FaceStatus::kEvaluated)
    return row + fmt::format(",{},{},,,,,,,,,,,,,,,\n", fixed(face.area_m2, 1, ""), face.n_over);
  const PlaneDifference& d = face.difference;
  return row + fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", text(face.verdict),
                           fixed(face.area_m2, 1, ""), face.n_over, cells(d.shift_m),
                           cells(d.height_m), cells(d.pitch_deg), cells(d.aspect_deg),
                           figure(d.angle_deg.value), figure(face.fit.rms_m),
                           figure(face.share_on_plane), figure(face.covered_share),
                           fixed(face.beyond_m2, 1, ""), fixed(face.missing_m2, 1, ""),
                           largest_offset(face));
}

}  // namespace

std::string faces_csv_header() {
  return "method,building,face,status,verdict,area_m2,n_points,shift_m,shift_95_m,height_m,"
         "height_95_m,pitch_deg,pitch_95_deg,aspect_deg,aspect_95_deg,angle_deg,rms_m,"
         "on_plane_share,covered_share,beyond_m2,missing_m2,outline_offset_m\n";
}

std::string faces_csv_rows(const std::string& method,
                           const std::string& building,
                           std::span<const FaceEvaluation> faces) {
  std::string text;
  for (const FaceEvaluation& face : faces) text += row_of(method, building, face);
  return text;
}

}  // namespace ridgeline::evaluate
