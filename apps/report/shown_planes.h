// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_input.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridgeline::apps {

/// A plane against which lines of a method were judged.
struct ShownPlane {
  std::uint64_t id = 0;                         ///< as in the evaluation
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};  ///< local; the fit with the most inliers
  int n_inliers = 0;
  double rms_m = 0.0;
  std::vector<Eigen::Vector3d> outline;  ///< convex, on the plane, around its shown points
};

/// The planes of a method's lines and the shown points that lie on them.
struct ShownPlanes {
  std::vector<ShownPlane> planes;  ///< by descending number of inliers
  /// For each shown point: its index in `planes` + 1, or 0 for none.
  std::vector<std::uint16_t> plane_of_point;
};

/// A point of the patch's cloud belongs to a plane of a line if it is within the judge's fitting
/// width of the line in plan (by default 4 m) and within its inlier distance of the plane (0.1 m);
/// if there are several such planes, it belongs to the nearest.
ShownPlanes shown_planes(const ReportPatch& patch, const ReportMethod& method);

}  // namespace ridgeline::apps
