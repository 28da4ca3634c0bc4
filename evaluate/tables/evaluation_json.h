// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <string>
#include <string_view>

namespace ridgeline::evaluate {

/// `evaluation.METHOD.json`: every line with its planes (in the world frame: n'x + d = 0 in the
/// CRS's coordinates), the summary per class, accuracy statements, strata and calibration, in full
/// precision. Missing figures are null.
std::string to_json(const Evaluation& evaluation);
Json evaluation_json(const Evaluation& evaluation);  ///< the content of to_json() as a value

/// Reads the output of to_json(). The figures are recomputed from the lines with the recorded
/// options, so that they are always consistent. The shift is read as recorded, because the lines
/// may have been moved by it. Throws std::invalid_argument "what: value; rule" for any other text.
Evaluation parse_evaluation(std::string_view json);

/// One row per line, in metres with 4 decimals:
/// id,patch,class,epipolar_angle_deg,kind,method,length_m,n_inliers,plane_rms_m,hull_coverage,
/// extrapolation_m,start_distance_m,end_distance_m,mean_distance_m,signed_mean_m,sigma_line_m,
/// sigma_plane_m,z,status,flags,horizontal_m,vertical_m,sigma_horizontal_m,sigma_vertical_m,
/// height_if_vertical_m,surface,surface_other,surface_probability,decided_by. Figures of two
/// planes, and flags, are separated by semicolons. If the lines were moved before they were judged,
/// moved_x_m,moved_y_m,moved_z_m follow.
std::string to_line_csv(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
