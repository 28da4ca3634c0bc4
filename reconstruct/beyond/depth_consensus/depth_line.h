// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace ridgeline::reconstruct {

/// A line in the projection plane of the base segment, conditioned frame.
struct DepthLine {
  Eigen::Vector3d through = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector
};

}  // namespace ridgeline::reconstruct
