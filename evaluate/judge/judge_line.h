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

/// A judged line and the points its planes were fitted to.
struct JudgedResult {
  LineEvaluation evaluation;
  /// For each plane the indices of its inliers in the cloud, sorted; empty unless
  /// JudgeOptions::keep_points.
  std::vector<std::vector<std::uint32_t>> inliers;
  /// For each plane a hash of each inlier's position, which identifies the point in any part of a
  /// cloud.
  std::vector<std::vector<std::uint64_t>> inlier_keys;
  /// For each plane the positions of its inliers, local; empty unless JudgeOptions::keep_points.
  std::vector<std::vector<Eigen::Vector3d>> inlier_points;
  /// For each plane the convex_hull() of its inliers, local.
  std::vector<std::vector<Eigen::Vector2d>> hulls;
};

/// Why a line cannot be judged, whatever the cloud holds.
struct Refusal {
  Status status;
  std::string reason;
};
/// The refusal of a line; nothing if it can be judged.
std::optional<Refusal> refusal_of(const JudgedLine& line);

/// The method (Ok et al. 2011, section 4) for one line:
/// the points of a planimetric corridor -> planes by sample consensus on each side, refined over
/// their connected points -> step edge (one plane) or ridge (two) -> average orthogonal distance.
/// The corridor lies where the image segment of the line meets the cloud. If the line
/// is known to lie on no surface there, the corridor lies where the line does. A line with a
/// reason_too_little_known() is ambiguous.
/// Every line gets a status; a bad line never throws.
JudgedResult judge_line(const PointSearch& search,
                        const JudgedLine& line,
                        const JudgeOptions& options);

}  // namespace ridgeline::evaluate
