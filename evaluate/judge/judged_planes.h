// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A LIDAR plane and all lines that were judged by it. Local frame.
struct JudgedPlane {
  std::uint64_t id = 0;                         ///< JudgingPlane::id
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};  ///< the fit with the most inliers
  int n_inliers = 0;                            ///< of that fit
  double rms_m = 0.0;
  int n_lines = 0;
  /// Plan hull of the inliers of all lines, placed on the plane, counter-clockwise seen from above;
  /// not closed.
  std::vector<Eigen::Vector3d> outline;
};

/// The planes of all results, sorted by id.
std::vector<JudgedPlane> judged_planes(std::span<const JudgedResult> results);

/// A laser point to which planes were fitted.
struct PlanePoint {
  Eigen::Vector3d x;           ///< local, m
  std::uint64_t plane_id = 0;  ///< of the nearest of these planes
  double distance_m = 0.0;     ///< from that plane, signed
};

/// The points kept in the results (JudgeOptions::keep_points), each once, sorted by plane, then by
/// x, y and z.
std::vector<PlanePoint> plane_points(std::span<const JudgedResult> results);

}  // namespace ridgeline::evaluate
