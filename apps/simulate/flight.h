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
  std::size_t number = 0;  ///< place in the flight, from 0; the key of its random streams
  ProjectionMatrix image_from_local;
  ProjectionMatrix image_from_world;
  Eigen::Vector3d centre_in_local = Eigen::Vector3d::Zero();
  Eigen::Vector2i size_px = Eigen::Vector2i::Zero();  ///< columns, rows
  InteriorOrientation interior;                       ///< of the image: off the middle in a window
  ExteriorOrientation exterior;                       ///< world
  /// The pixels (first and last column and row) that may show the village: all of them, but in a
  /// frame those around its mesh. Empty if a frame shows none.
  Eigen::AlignedBox2i village_px;

  /// Unit vector from the projection centre through a pixel, local axes.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& x_px) const {
    return (ray_from_pixel * x_px.homogeneous()).normalized();
  }
  /// Angle between the rays of neighbouring pixels at the principal point.
  [[nodiscard]] double pixel_angle_rad() const { return ray_from_pixel.col(0).norm(); }
  Eigen::Matrix3d ray_from_pixel = Eigen::Matrix3d::Identity();
};

/// The views of a flight in the order of planned_views(): the first two are the pair. Each window
/// is the smallest that shows the plan on the mean terrain with the margin, or has the size asked
/// for; or all are whole frames. Deterministic by seed. Throws std::invalid_argument for an option
/// outside its range, for sizes of other than all views or beside frames, for images of more than
/// 300 megapixels, where the plan reaches behind a tilted view, and for a frame that does not show
/// the middle of the plan or looks at the horizon.
std::vector<AerialView> aerial_views(const SyntheticScene& scene, const FlightOptions& options);

/// The same of views that are planned in another way, as those of a block. Frames may show any part
/// of the plan, or none.
std::vector<AerialView> aerial_views(const SyntheticScene& scene,
                                     const FlightOptions& options,
                                     std::span<const PlannedView> planned);

/// Two heights (world) between which the whole scene lies: whole metres, 50 m apart or more.
std::array<double, 2> height_range_m(const SyntheticScene& scene);

/// Projection matrices of two exactly vertical frames with the defaults of FlightOptions: the
/// geometry of Ok et al. 2011, section 4, without errors of the flight.
std::array<ProjectionMatrix, 2> nominal_pair(const SyntheticScene& scene);

/// Sets the epipolar angle of a line in two or more views and the class that follows from it:
/// `aligned` up to 10 degrees, else `not_aligned`. The pair with the largest angle decides.
void set_class(std::span<const ProjectionMatrix> image_from_world, io::Line& line);

/// All lines with their class by set_class().
io::LineSet classed_by_views(io::LineSet lines, std::span<const ProjectionMatrix> image_from_world);

}  // namespace ridgeline::simulate
