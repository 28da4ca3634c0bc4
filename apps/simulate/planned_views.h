// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight_options.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// Where a view is to be taken; the errors of the flight come on top.
struct PlannedView {
  std::string id;
  std::size_t number = 0;  ///< place in the flight, from 0
  /// Projection centre from the middle of the plan on the ground.
  Eigen::Vector3d from_middle_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d world_from_camera_axes = Eigen::Matrix3d::Identity();
};

/// All views of a flight. Two are `left` and `right`, more have the name of their group and a
/// number from 1. The base view comes first, then its neighbour in its group, because the first two
/// views are the pair of all that takes a pair; then the others as they are flown. The base is the
/// view of the first group that is nearest to the middle of the plan, of several the first. Throws
/// std::invalid_argument as check_view_groups().
std::vector<PlannedView> planned_views(const FlightOptions& options);

}  // namespace ridgeline::simulate
