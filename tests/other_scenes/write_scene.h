// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/flight_plan.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::other {

/// What makes the images of some views worse than those of a good camera.
struct Degradation {
  double blur_px = 0.0;              ///< sigma of a Gaussian in addition to the optics, 0 to 20
  bool bayer = false;                ///< see Film
  int jpeg_quality = 0;              ///< see Film
  std::vector<std::string> views{};  ///< ids of cameras_for(); empty: all
};

/// Makes the settlement of a seed and its photographs in `folder`, which must be there: patch.yaml
/// (id: the seed), ID.tif of each view (cameras_for()), matches.csv (all straight edges that the
/// first two show) and truth.geojson (all that any two show, as 3D lines). visible_left,
/// visible_right of a line are of the two views that show most of it. More than two views: its
/// class by the largest epipolar angle of all pairs of views that show it, and their number as
/// n_images. No LIDAR. `is_hard`: the hard settlement with its laser points, lidar.las with 5 per
/// m2, and the kinds of SurfaceLine in truth.geojson. Throws io::IoError; std::invalid_argument for
/// a value of the degradation outside its range or a view that does not exist.
void write_scene(const std::string& folder,
                 std::uint64_t seed,
                 const FlightPlan& plan = {},
                 bool is_hard = false,
                 const Degradation& degradation = {});

/// Of the local frame of a scene in the CRS of its files.
Eigen::Vector3d scene_origin_m();

}  // namespace ridgeline::other
