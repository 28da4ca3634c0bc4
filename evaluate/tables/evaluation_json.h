// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// `evaluation.METHOD.json`: every line with its planes (in the world frame: n'x + d = 0 in the
/// CRS's coordinates), the summary per class, accuracy statements, strata and calibration, in full
/// precision. A figure that does not exist is null.
std::string to_json(const Evaluation& evaluation);
Json evaluation_json(const Evaluation& evaluation);  ///< the content of to_json() as a value

/// Reads what to_json() wrote. The figures are computed anew from the lines with the recorded
/// options, so that they cannot disagree with them. The shift is read: the lines may have been
/// moved by it. Throws std::invalid_argument "what: value; rule" for text that is no such file.
Evaluation parse_evaluation(std::string_view json);

/// One row per line with 4 decimals in metres:
/// id,patch,class,epipolar_angle_deg,kind,method,length_m,n_inliers,plane_rms_m,hull_coverage,
/// extrapolation_m,start_distance_m,end_distance_m,mean_distance_m,signed_mean_m,sigma_line_m,
/// sigma_plane_m,z,status,flags,horizontal_m,vertical_m,sigma_horizontal_m,sigma_vertical_m,
/// height_if_vertical_m,surface,surface_other,surface_probability,decided_by. Figures of two planes
/// and flags are separated by a semicolon. Of lines that were moved before they were judged,
/// moved_x_m,moved_y_m,moved_z_m follow.
std::string to_line_csv(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
