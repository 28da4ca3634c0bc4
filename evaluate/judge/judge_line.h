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
  /// Per plane, indices into the cloud, sorted; only if options keep the points.
  std::vector<std::vector<std::uint32_t>> inliers;
  /// The same points by a hash of their position, which tells them in any part of a cloud.
  std::vector<std::vector<std::uint64_t>> inlier_keys;
  std::vector<std::vector<Eigen::Vector3d>>
      inlier_points;  ///< the same points if options keep them
  std::vector<std::vector<Eigen::Vector2d>>
      hulls;  ///< per plane, convex_hull() of the inliers, local
};

/// Why a line cannot be judged whatever the cloud holds; nothing if it can.
struct Refusal {
  Status status;
  std::string reason;
};
std::optional<Refusal> refusal_of(const JudgedLine& line, const JudgeOptions& options);

/// The method (Ok et al. 2011, section 4) for one line:
/// the points of a planimetric corridor -> planes by sample consensus on each side, refined over
/// their connected points -> step edge (one plane) or ridge (two) -> average orthogonal distance.
/// The corridor lies where the image segment of the line meets the cloud. If the images show the line on
/// no plane there, it lies where the line does, provided that the images show it on the plane there (flag
/// `seen_instead`). A line with a reason_for_doubt() is ambiguous.
/// Ends in a status whatever the line is; never throws for a bad line.
JudgedResult judge_line(const PointSearch& search,
                        const JudgedLine& line,
                        const JudgeOptions& options);

}  // namespace ridgeline::evaluate
