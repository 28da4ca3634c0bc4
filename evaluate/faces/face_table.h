// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"

#include <span>
#include <string>

namespace ridgeline::evaluate {

/// The header of `faces.csv`: method,building,face,status,verdict,area_m2,n_points,shift_m,shift_95_m,height_m,height_95_m,pitch_deg,
/// pitch_95_deg,aspect_deg,aspect_95_deg,angle_deg,rms_m,on_plane_share,covered_share,beyond_m2,missing_m2,outline_offset_m. Differences are model
/// minus scan; `_95` is the half width of the 95 % interval; `outline_offset_m` is the largest one of an edge, positive outwards.
std::string faces_csv_header();

/// The rows of a building's faces. An empty cell is a figure that does not exist.
std::string faces_csv_rows(const std::string& method,
                           const std::string& building,
                           std::span<const FaceEvaluation> faces);

}  // namespace ridgeline::evaluate
