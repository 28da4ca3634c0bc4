// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/view_groups.h"
#include "reconstruct/geometry/field.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace ridgeline::simulate {

/// Limits of the side lengths of a whole frame.
inline constexpr int kMinFrameSide_px = 100;
inline constexpr int kMaxFrameSide_px = 30000;

/// A flight over the scene; defaults: the DMC block of Ok et al. 2011, section 4 (GSD 8 cm).
struct FlightOptions {
  std::vector<ViewGroup> groups{{ViewGroupKind::kStrip, 2}};
  double focal_length_px = 10000.0;
  double height_above_ground_m = 800.0;
  double base_to_height = 0.26;  ///< of neighbouring views in a strip
  double oblique_tilt_deg = 35.0;
  double attitude_sigma_deg = 0.4;  ///< errors of omega, phi and kappa of each view
  double position_sigma_m = 2.0;    ///< error of each projection centre, per axis
  double sun_step_deg = 0.0;        ///< motion of the sun from view to view
  /// Margin of the image around the plan. A negative margin cuts off the border of the plan, a
  /// straight edge that no landscape has.
  double margin_m = -2.0;
  /// Columns and rows of each image, around the middle of the plan. Empty: the images show the
  /// whole plan.
  std::vector<Eigen::Vector2i> size_px;
  /// Columns and rows of whole frames, with the principal point in the middle, instead of images
  /// around the plan.
  std::optional<Eigen::Vector2i> frame_px;
  std::uint64_t seed = 1;

  static constexpr auto fields() {
    using O = FlightOptions;
    return std::tuple{
        Field{"focal_length_px", &O::focal_length_px, 500.0, 100000.0, "of all views"},
        Field{"camera_height_m", &O::height_above_ground_m, 100.0, 10000.0,
              "of the projection centres above the ground; of oblique views their distance to it"},
        Field{"base_to_height", &O::base_to_height, 0.02, 1.0,
              "base of neighbours in a strip over height"},
        Field{"oblique_tilt_deg", &O::oblique_tilt_deg, 5.0, 60.0,
              "of oblique views to the vertical"},
        Field{"attitude_sigma_deg", &O::attitude_sigma_deg, 0.0, 5.0,
              "of omega, phi, kappa of each view"},
        Field{"position_sigma_m", &O::position_sigma_m, 0.0, 50.0,
              "of each projection centre, per axis"},
        Field{"sun_step_deg", &O::sun_step_deg, -90.0, 90.0,
              "azimuth of the sun from one view to the next"},
        Field{"image_margin_m", &O::margin_m, -20.0, 100.0,
              "of the images around the plan; negative: within it"}};
  }
};

/// The flight of Chio and Wang 2000, section 4: pixels of 30 um at an image scale of 1:8,000, hence
/// a ground pixel of 0.24 m, images of 180 x 180 and 225 x 180 pixels. The paper does not specify
/// the camera; 15 cm focal length, 23 cm frames and 60 % overlap were customary.
FlightOptions chio_wang_flight();

}  // namespace ridgeline::simulate
