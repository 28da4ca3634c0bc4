// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight_options.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// The planned pose of a view, before the errors of the flight are added.
struct PlannedView {
  std::string id;
  std::size_t number = 0;  ///< position in the flight, from 0
  /// Projection centre relative to the middle of the plan on the ground.
  Eigen::Vector3d from_middle_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d world_from_camera_axes = Eigen::Matrix3d::Identity();
};

/// All views of a flight. Two views are called `left` and `right`; with more, each has the name of
/// its group and a number from 1. The base view comes first, then its neighbour in its group,
/// because commands that need a pair use the first two views; the others follow in flight order.
/// The base is the view of the first group that is nearest to the middle of the plan, or the first
/// of several. Throws std::invalid_argument under the same conditions as check_view_groups().
std::vector<PlannedView> planned_views(const FlightOptions& options);

}  // namespace ridgeline::simulate
