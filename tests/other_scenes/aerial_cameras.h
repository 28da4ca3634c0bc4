// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/flight_plan.h"
#include "tests/other_scenes/ray_tracer.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::other {

/// A window of a frame image, in the local metres of its scene. Pixel (0,0) is the centre of the
/// top-left pixel of the window.
struct AerialCamera {
  std::string id;                          ///< of its image
  Eigen::Vector3d centre;                  ///< projection centre
  Eigen::Matrix3d camera_from_local_axes;  ///< camera axes: x right, y down, z into the scene
  double focal_length_px = 10000.0;
  Eigen::Vector2d principal_point_px = Eigen::Vector2d::Zero();  ///< in the window
  int columns = 0, rows = 0;

  [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& x) const;
  [[nodiscard]] Ray ray(const Eigen::Vector2d& x_px) const;  ///< direction not of unit length
  [[nodiscard]] bool shows(const Eigen::Vector2d& x_px) const;
  /// 3 x 4, of coordinates whose local ones are x - origin.
  [[nodiscard]] Eigen::Matrix<double, 3, 4> image_from_world(const Eigen::Vector3d& origin_m) const;
};

/// 800 m above the scene, 208 m from one to the next of a strip, the strip within 2 degrees of the
/// x axis and the cross strip within 2 degrees of the y axis, attitude angles of about a degree,
/// windows that show the patch of the scene. Ids: left, right of a pair, else strip1.., cross1..
/// First come the view in the middle of the strip and the next one of the strip, then the others as
/// they were flown.
std::vector<AerialCamera> cameras_for(const Scene& scene,
                                      std::uint64_t seed,
                                      const FlightPlan& plan);

}  // namespace ridgeline::other
