// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// `faces.csv`, one row per face:
/// method,building,face,status,verdict,area_m2,slope_deg,flatness_m,n_over,n_on_plane,rms_m,
/// shift_m,shift_95_m,height_m,height_95_m,angle_deg,angle_95_deg,pitch_deg,pitch_95_deg,
/// aspect_deg,aspect_95_deg,share_on_plane,covered_share,beyond_m2,missing_m2,
/// largest_offset_m. Columns with 95 are half widths of intervals; largest_offset_m is the offset,
/// with its sign, that is largest in magnitude over the edges. Four decimals, one for areas;
/// missing values are left empty. Throws std::invalid_argument if evaluations and buildings do not
/// match.
std::string faces_csv_header();
std::string faces_csv_rows(const std::string& method,
                           std::span<const RoofBuilding> buildings,
                           std::span<const std::vector<FaceEvaluation>> evaluations);

}  // namespace ridgeline::evaluate
