// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ridgeline::evaluate {

/// Normals of a cloud's points for the sample consensus (pcl::SampleConsensusModelNormalPlane): a
/// point counts by weight (1 - curvature) times its normal's angle to the plane in radians, plus
/// the rest times its distance in metres. A point of curvature 1 counts by its distance alone.
struct PointNormals {
  struct Normal {
    float x, y, z;    ///< unit, either sign
    float curvature;  ///< from 0 to 1
  };
  std::vector<Normal> of_point;  ///< by PointSearch::Point::index; empty: distances alone
  double weight = 0.1;           ///< from 0 to 1
};

}  // namespace ridgeline::evaluate
