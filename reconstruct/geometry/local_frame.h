// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace ridgeline {

/// The frame of all computations: `x_in_local = x_in_world - origin_m`. The origin is in whole
/// metres, so that the subtraction loses no precision with map coordinates. World is the CRS of the
/// data, in metres. All inputs of a run share one frame.
struct LocalFrame {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Vector3d local_from_world(const Eigen::Vector3d& x_in_world) const {
    return x_in_world - origin_m;
  }
  [[nodiscard]] Eigen::Vector3d world_from_local(const Eigen::Vector3d& x_in_local) const {
    return x_in_local + origin_m;
  }
};

}  // namespace ridgeline
