// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight_options.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/scene.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// A perspective image of the scene: a whole frame or a window of one, without distortion.
struct AerialView {
  std::string id;
  std::size_t number = 0;  ///< position in the flight, from 0; the key of its random streams
  ProjectionMatrix image_from_local;
  ProjectionMatrix image_from_world;
  Eigen::Vector3d centre_in_local = Eigen::Vector3d::Zero();
  Eigen::Vector2i size_px = Eigen::Vector2i::Zero();  ///< columns, rows
  InteriorOrientation interior;  ///< of the image: in a window, the principal point is off-centre
  ExteriorOrientation exterior;  ///< world
  /// The pixels (first and last column and row) that may show the village: in a frame, those around
  /// its mesh, otherwise all of them. Empty if a frame does not show the village.
  Eigen::AlignedBox2i village_px;

  /// Unit vector from the projection centre through a pixel, local axes.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& x_px) const {
    return (ray_from_pixel * x_px.homogeneous()).normalized();
  }
  /// Angle between the rays of neighbouring pixels at the principal point.
  [[nodiscard]] double pixel_angle_rad() const { return ray_from_pixel.col(0).norm(); }
  Eigen::Matrix3d ray_from_pixel = Eigen::Matrix3d::Identity();
};

/// The views of a flight in the order of planned_views(): the first two are the pair. Unless they
/// are whole frames, each is the smallest window that shows the plan on the mean terrain with the
/// margin, or has the requested size. Deterministic for a given seed. Throws std::invalid_argument
/// for an option outside its range, for sizes that are not given for all views or are combined with
/// whole frames, for images of more than 300 megapixels, for a plan that extends behind a tilted
/// view, and for a frame that does not show the middle of the plan or shows the horizon.
std::vector<AerialView> aerial_views(const SyntheticScene& scene, const FlightOptions& options);

/// As above, for views planned otherwise, such as those of a block. Frames may show any part of the
/// plan, or none.
std::vector<AerialView> aerial_views(const SyntheticScene& scene,
                                     const FlightOptions& options,
                                     std::span<const PlannedView> planned);

/// Two heights (world) between which the whole scene lies: whole metres, at least 50 m apart.
std::array<double, 2> height_range_m(const SyntheticScene& scene);

/// Projection matrices of two exactly vertical frames with the defaults of FlightOptions: the
/// geometry of Ok et al. 2011, section 4, without flight errors.
std::array<ProjectionMatrix, 2> nominal_pair(const SyntheticScene& scene);

/// Sets the epipolar angle of a line in two or more views and the resulting class: `aligned` up to
/// 10 degrees, otherwise `not_aligned`. The pair with the largest angle decides.
void set_class(std::span<const ProjectionMatrix> image_from_world, io::Line& line);

/// Applies set_class() to all lines.
io::LineSet classed_by_views(io::LineSet lines, std::span<const ProjectionMatrix> image_from_world);

}  // namespace ridgeline::simulate
