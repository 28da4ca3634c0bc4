// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/options.h"
#include "evaluate/judge/point_grid.h"
#include "evaluate/line_evaluation.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A judged line and the points to which its planes were fitted.
struct JudgedResult {
  LineEvaluation evaluation;
  /// For each plane, the sorted indices of its inliers in the cloud; empty unless
  /// JudgeOptions::keep_points.
  std::vector<std::vector<std::uint32_t>> inliers;
  /// For each plane, a hash of the position of each inlier, which identifies the point in any part
  /// of a cloud.
  std::vector<std::vector<std::uint64_t>> inlier_keys;
  /// For each plane, the positions of its inliers, local; empty unless JudgeOptions::keep_points.
  std::vector<std::vector<Eigen::Vector3d>> inlier_points;
  /// For each plane, the convex_hull() of its inliers, local.
  std::vector<std::vector<Eigen::Vector2d>> hulls;
};

/// Why a line cannot be judged, whatever the cloud contains.
struct Refusal {
  Status status;
  std::string reason;
};
/// The refusal of a line; empty if it can be judged.
std::optional<Refusal> refusal_of(const JudgedLine& line);

/// The method (Ok et al. 2011, section 4) for one line:
/// the points of a planimetric corridor -> planes by sample consensus on each side, refined over
/// their connected points -> step edge (one plane) or ridge (two) -> average orthogonal distance.
/// The corridor lies where the image segment of the line meets the cloud. If the line is known to
/// lie on no surface there, the corridor is placed at the line itself. A line for which
/// reason_too_little_known() gives a reason is ambiguous.
/// Every line gets a status; an invalid line never throws.
JudgedResult judge_line(const PointSearch& search,
                        const JudgedLine& line,
                        const JudgeOptions& options);

}  // namespace ridgeline::evaluate
