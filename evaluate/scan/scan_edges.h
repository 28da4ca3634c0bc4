// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_fit.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A plane on which connected points of a scan lie. Local frame, metres.
struct ScanPlane {
  PlaneFit fit;
  double area_m2 = 0.0;  ///< covered by its points, on the plane
  bool is_roof = false;  ///< whether most of its border lies above what surrounds it
  /// Of roofs, the border of their points: closed chains without a repeated first point, with the
  /// plane to the left seen from above. Empty for other planes.
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/// A straight edge of the roofs of a scan. Local frame, metres.
struct ScanEdge {
  Segment3 segment;
  /// "ridge", "hip" or "valley" where two planes meet; "eave", "verge" or "step" at the border of
  /// one; see edges_of_roofs().
  std::string kind;
  std::vector<std::size_t> planes;  ///< indices into ScanEdges::planes: two, or one for a border
  /// Covariance of (start, end), m^2. The part along the line is that of its ends.
  Eigen::Matrix<double, 6, 6> covariance_m2 = Eigen::Matrix<double, 6, 6>::Zero();
  double support = 0.0;  ///< share of its length that has points beside it, 0..1
  /// By how much a border was moved out beyond the outermost points; 0 where two planes meet.
  double moved_out_m = 0.0;
};

struct ScanEdges {
  std::vector<ScanPlane> planes;
  std::vector<ScanEdge> edges;
};

}  // namespace ridgeline::evaluate
