// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/field.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace ridgeline::simulate {

/// A stereo flight over the scene; defaults: the DMC block of Ok et al. 2011, section 4 (GSD 8 cm).
struct FlightOptions {
  double focal_length_px = 10000.0;
  double height_above_ground_m = 800.0;
  double base_to_height = 0.26;     ///< the base lies along x
  double attitude_sigma_deg = 0.4;  ///< errors of omega, phi and kappa of each view
  double position_sigma_m = 2.0;    ///< error of each projection centre, per axis
  /// Margin of the image around the plan. A negative margin cuts off the border of the plan, a straight edge that no
  /// landscape has.
  double margin_m = -2.0;
  /// Columns and rows of the images, around the middle of the plan. 0: the images show the whole plan.
  std::array<Eigen::Vector2i, 2> size_px{Eigen::Vector2i::Zero(), Eigen::Vector2i::Zero()};
  std::uint64_t seed = 1;

  static constexpr auto fields() {
    using O = FlightOptions;
    return std::tuple{
        Field{"focal_length_px", &O::focal_length_px, 500.0, 100000.0, "of both views"},
        Field{"camera_height_m", &O::height_above_ground_m, 100.0, 10000.0,
              "of the projection centres above the ground"},
        Field{"base_to_height", &O::base_to_height, 0.02, 1.0, "base along x over height"},
        Field{"attitude_sigma_deg", &O::attitude_sigma_deg, 0.0, 5.0,
              "of omega, phi, kappa of each view"},
        Field{"position_sigma_m", &O::position_sigma_m, 0.0, 50.0,
              "of each projection centre, per axis"},
        Field{"image_margin_m", &O::margin_m, -20.0, 100.0,
              "of the images around the plan; negative: within it"}};
  }
};

/// The flight of Chio and Wang 2000, section 4: pixels of 30 um at an image scale of 1:8,000, hence a
/// ground pixel of 0.24 m, images of 180 x 180 and 225 x 180 pixels. The paper does not give the
/// camera; 15 cm focal length, 23 cm frames and 60 % overlap were the rule.
FlightOptions chio_wang_flight();

/// A perspective image of the scene: a window of a full frame, without distortion.
struct AerialView {
  ProjectionMatrix image_from_local;
  ProjectionMatrix image_from_world;
  Eigen::Vector3d centre_in_local = Eigen::Vector3d::Zero();
  Eigen::Vector2i size_px = Eigen::Vector2i::Zero();  ///< columns, rows

  /// Unit vector from the projection centre through a pixel, local axes.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& x_px) const {
    return (ray_from_pixel * x_px.homogeneous()).normalized();
  }
  /// Angle between the rays of neighbouring pixels at the principal point.
  [[nodiscard]] double pixel_angle_rad() const { return ray_from_pixel.col(0).norm(); }
  Eigen::Matrix3d ray_from_pixel = Eigen::Matrix3d::Identity();
};

/// The left and the right view: each window is the smallest that shows the plan on the mean
/// terrain with the margin, or has the size asked for. Deterministic by seed. Throws std::invalid_argument for an option
/// outside its range, and for images of more than 300 megapixels.
std::array<AerialView, 2> aerial_pair(const Scene& scene, const FlightOptions& options);

/// Two heights (world) between which the whole scene lies: whole metres, 50 m apart or more.
std::array<double, 2> height_range_m(const Scene& scene);

/// Projection matrices of two exactly vertical frames with the defaults of FlightOptions: the
/// geometry of Ok et al. 2011, section 4, without errors of the flight.
std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene);

/// The lines with their epipolar angle in a pair and the class that follows from it:
/// `aligned` up to 10 degrees, else `not_aligned`.
io::LineSet classed_by_pair(io::LineSet lines, const std::array<ProjectionMatrix, 2>& pair);

}  // namespace ridgeline::simulate
