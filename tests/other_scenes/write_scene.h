// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/flight_plan.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace ridgeline::other {

/// Makes the settlement of a seed and its photographs in `folder`, which must be there: patch.yaml
/// (id: the seed), ID.tif of each view (cameras_for()), matches.csv (all straight edges that the first
/// two show) and truth.geojson (all that any two show, as 3D lines). visible_left, visible_right of a
/// line are of the two views that show most of it. More than two views: its class by the largest
/// epipolar angle of all pairs of views that show it, and their number as n_images. No LIDAR.
/// `is_hard`: the hard settlement with its laser points, lidar.las with 5 per m2, and the kinds of
/// SurfaceLine in truth.geojson. Throws io::IoError.
void write_scene(const std::string& folder,
                 std::uint64_t seed,
                 const FlightPlan& plan = {},
                 bool is_hard = false);

/// Of the local frame of a scene in the CRS of its files.
Eigen::Vector3d scene_origin_m();

}  // namespace ridgeline::other
