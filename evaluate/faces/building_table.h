// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/edge_heights.h"
#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/point_distances.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/line_evaluation.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

enum class BuildingVerdict : std::uint8_t {
  /// Less than half of the roof area could be judged, or the faces are right but the lines are not.
  kNotJudged,
  kRight,
  kShifted,      ///< in plan as a whole
  kTooHigh,      ///< as a whole
  kTooLow,       ///< as a whole
  kWrongHeight,  ///< the largest wrong share of the area is of this kind; likewise for the next two
  kWrongTilt,
  kWrongOutline,
  kChanged,  ///< too many points over it lie on none of its planes: the roof in the scan has a
             ///< different shape
  kGone,     ///< the scan shows the ground in its place
};
inline constexpr std::array kBuildingVerdicts{
    BuildingVerdict::kRight,        BuildingVerdict::kShifted,     BuildingVerdict::kTooHigh,
    BuildingVerdict::kTooLow,       BuildingVerdict::kWrongHeight, BuildingVerdict::kWrongTilt,
    BuildingVerdict::kWrongOutline, BuildingVerdict::kChanged,     BuildingVerdict::kGone,
    BuildingVerdict::kNotJudged};
/// "right", "shifted", "too high", "too low", "wrong height", "wrong tilt", "wrong outline",
/// "changed", "gone" or "not judged".
const char* text(BuildingVerdict verdict);

/// Edges of the scan on a building.
struct ScanEdgeCount {
  int n = 0;
  int n_missing = 0;  ///< of which the model has less than half
};

/// A building with the results of its judged lines and faces.
struct BuildingRow {
  std::string id;
  BuildingVerdict verdict = BuildingVerdict::kNotJudged;

  int n_lines = 0, n_judged_lines = 0;  ///< lines by LineEvaluation::building
  std::optional<double> rms_m;          ///< of the judged lines' mean distances
  std::string worst_line;  ///< the judged line with the largest mean distance, the first if there
                           ///< are several; "" for none
  std::optional<double> worst_distance_m;

  int n_faces = 0, n_judged_faces = 0;
  double area_m2 = 0.0;         ///< of its faces except walls, on their planes
  double judged_area_m2 = 0.0;  ///< of the judged faces: evaluated ones and those without a plane
  /// Shares of judged_area_m2 by the faces' verdicts; a face may belong to several. A face without
  /// a plane belongs to none.
  double wrong_height = 0.0, wrong_tilt = 0.0, wrong_outline = 0.0;
  EdgeHeights heights;
  /// Share of the points over the judged faces that lie on none of the planes of nearby faces;
  /// empty if there are no points.
  std::optional<double> unexplained;
  /// If the building is shifted, too high or too low: model minus scan, local.
  std::optional<Eigen::Vector3d> shift_m;

  std::size_t n_points = 0;  ///< number of points in points_rms_m
  /// Root mean square and 90 % quantile of PointDistances::to_surface_m, root mean square of
  /// to_roof_m.
  std::optional<double> points_rms_m, points_p90_m, roof_points_rms_m;
  double covered = 0.0;  ///< share of area_m2 that has points on its faces' planes nearby
  std::optional<ScanEdgeCount> scan_edges{};  ///< empty if the model was not compared with them
};

/// One row per building, in the order of the buildings.
/// @param evaluations  of each building's faces, from judge_faces()
/// @param points       of each building
/// @param lines        of any buildings; lines of buildings not given are ignored
/// Throws std::invalid_argument if evaluations or points do not match the buildings.
std::vector<BuildingRow> building_table(std::span<const RoofBuilding> buildings,
                                        std::span<const std::vector<FaceEvaluation>> evaluations,
                                        std::span<const PointDistances> points,
                                        std::span<const LineEvaluation> lines);

/// `buildings.csv`:
/// method,id,verdict,n_lines,n_judged_lines,rms_m,worst_line,worst_distance_m,n_faces,
/// n_judged_faces,area_m2,judged_area_m2,wrong_height_share,wrong_tilt_share,wrong_outline_share,
/// ridge_height_m,eave_height_m,unexplained_share,shift_x_m,shift_y_m,shift_z_m,n_points,
/// points_rms_m,points_p90_m,roof_points_rms_m,covered_share.
/// Heights and shifts are model minus scan. Four decimals, one for areas; missing values are left
/// empty. `with_scan_edges`: n_scan_edges,n_missing_edges follow.
std::string buildings_csv_header(bool with_scan_edges);
/// The rows of one method; all or none of them with edges of the scan.
std::string buildings_csv_rows(const std::string& method, std::span<const BuildingRow> rows);

}  // namespace ridgeline::evaluate
