// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ridgeline::evaluate {

/// Normals of a cloud's points for the sample consensus (pcl::SampleConsensusModelNormalPlane):
/// with w = weight (1 - curvature), the error of a point is w times the angle in radians between
/// its normal and that of the plane, plus 1 - w times its distance in metres. For a point of
/// curvature 1 only the distance counts.
struct PointNormals {
  struct Normal {
    float x, y, z;    ///< unit, either sign
    float curvature;  ///< from 0 to 1
  };
  std::vector<Normal> of_point;  ///< by PointSearch::Point::index; if empty, only distances count
  double weight = 0.1;           ///< from 0 to 1
};

}  // namespace ridgeline::evaluate
