// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// States what the distances are and what they are not. Accompanies every accuracy table.
inline constexpr std::string_view kFixedSentence =
    "Orthogonal distances between lines and LIDAR planes; not an ASPRS or NSSDA checkpoint test. "
    "Figures in their style are informative.";

/// The figures of one method on one patch.
struct PatchMethodResult {
  std::string patch, method;
  std::vector<Summary> classes;              ///< not_aligned, aligned, total; or only total
  std::optional<Eigen::Vector3d> moved_m{};  ///< applied to the lines before they were judged
};

/// RMS of the lines' distances per patch, method and class (Ok et al. 2011, Table 2). All
/// renderings print these figures.
struct Table2 {
  std::vector<PatchMethodResult> results;  ///< in the order of the rows
  /// Whether `joint` ran with the extension `faces_beside`, which also changes not_aligned lines.
  bool joint_adjusts_to_faces = false;
  std::vector<std::string> moved;  ///< moved_notes() of the evaluations
};

/// One result per evaluation, on its own lines; on_common_lines() gives the paired set.
Table2 make_table2(std::span<const Evaluation> evaluations, bool joint_adjusts_to_faces = false);

/// A line of text with the qualifications of the figures; "" without any:
///   - which lines were moved before they were judged;
///   - why direct and joint differ on not_aligned lines, for which the papers' methods agree, if
///     both were run and joint adjusted lines to faces.
std::string footnote(const Table2& table);

/// The published form: a row per patch, methods side by side, RMS with evaluated/all lines in
/// every cell; below it a row per cell with interval, bias and robust figures, the excluded lines
/// by reason, and kFixedSentence. If the surface of some lines was decided by points or place,
/// cells show headline_text(), and each is broken down into the rows returned by rows_of().
std::string to_markdown(const Table2& table);

/// `patch,method,class,n_lines,n_evaluated,rms_m,ci95_low_m,ci95_high_m,median_m,nmad_m,q95_m,
/// n_plan_images,rms_plan_images_m,n_points_place,rms_points_place_m`: one row per class,
/// for all its lines, with the RMS of each of kDecidedGroups; missing values are left empty. If any
/// lines were moved before they were judged, moved_x_m,moved_y_m,moved_z_m follow.
std::string to_csv(const Table2& table);

/// `patch,method,class,n_ridges,rmse_horizontal_m,rmse_vertical_m,mean_vertical_m`: the error
/// components of ridges and hips, see RidgeDisplacement.
std::string parts_to_csv(const Table2& table);

/// Every figure in full precision: {"rows": [{patch, method, class, ...}], "note": ..., "footnote":
/// ...}.
std::string to_json(const Table2& table);

/// A `tabular` with booktabs rules in the published layout, n in every cell.
std::string to_latex(const Table2& table);

}  // namespace ridgeline::evaluate
