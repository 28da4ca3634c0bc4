// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ridgeline::io {

/// Converts the coordinates of a cloud file to local metres: x_in_local = unit_m * x_in_file -
/// origin_m for each axis. The origin is subtracted in double, before any rounding to a shorter
/// type.
struct LocalFromFile {
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();  ///< metres per file unit (feet: 0.3048)
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::AlignedBox3d operator()(const Eigen::AlignedBox3d& box_in_file) const {
    return {unit_m.cwiseProduct(box_in_file.min()) - origin_m,
            unit_m.cwiseProduct(box_in_file.max()) - origin_m};
  }
};

}  // namespace ridgeline::io
