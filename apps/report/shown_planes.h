// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_input.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridgeline::apps {

/// A plane that lines of a method were judged by.
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
  /// Index in `planes` + 1 of each shown point, 0 for none.
  std::vector<std::uint16_t> plane_of_point;
};

/// Points of the patch's cloud within the judge's width of fitting (by default 4 m) of a line in
/// plan and its inlier distance (0.1 m) of one of the line's planes belong to that plane, to the
/// nearest if there are several.
ShownPlanes shown_planes(const ReportPatch& patch, const ReportMethod& method);

}  // namespace ridgeline::apps
