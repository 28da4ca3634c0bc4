// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/aerial_pair.h"

#include "apps/simulate/random.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <numbers>

namespace ridgeline::simulate {
namespace {

constexpr std::uint64_t kFlightStream = 0x666c69676874;

/// The pixels of the full frame, whose principal point is pixel (0, 0), that show the plan.
Eigen::AlignedBox2d frame_window(const Scene& scene,
                                 const ProjectionMatrix& frame_from_world,
                                 double margin_m) {
  Eigen::AlignedBox2d window;
  for (const double x : {-margin_m, scene.extent_m.x() + margin_m}) {
    for (const double y : {-margin_m, scene.extent_m.y() + margin_m}) {
      const Eigen::Vector3d corner(x, y, scene.mean_terrain({x, y}));
      window.extend(project(frame_from_world, scene.frame.world_from_local(corner)));
    }
  }
  return window;
}

/// Limits the memory that light and grey values need to some gigabytes.
void check_num_pixels(const Eigen::Vector2d& size_px) {
  constexpr double kMostPixels = 3e8;
  check(size_px.prod() <= kMostPixels, "images of ", size_px.x(), " x ", size_px.y(),
        " pixels; must be of 300 megapixels at most: choose a smaller extent, a greater camera "
        "height or no images");
}

AerialView view_at(const Scene& scene,
                   const FlightOptions& options,
                   const Eigen::Vector2i& size_px,
                   const ExteriorOrientation& exterior) {
  InteriorOrientation interior;
  interior.focal_length_px.setConstant(options.focal_length_px);
  const ProjectionMatrix frame_from_world = projection_matrix(interior, exterior);
  Eigen::AlignedBox2d window = frame_window(scene, frame_from_world, options.margin_m);
  if ((size_px.array() > 0).all()) {
    const Eigen::Vector2d corner = (window.center() - 0.5 * size_px.cast<double>()).array().round();
    const Eigen::Vector2i steps = size_px - Eigen::Vector2i::Ones();
    window = {corner, corner + steps.cast<double>()};
  }
  const Eigen::Vector2d corner_px = window.min().array().floor();

  AerialView view;
  const Eigen::Vector2d last_px = (window.max() - corner_px).array().ceil();
  check_num_pixels(last_px);
  view.size_px = last_px.cast<int>().array() + 1;
  view.image_from_world = window_from_world(frame_from_world, corner_px);
  view.image_from_local = image_from_local(view.image_from_world, scene.frame.origin_m);
  view.centre_in_local = scene.frame.local_from_world(exterior.position_m);
  view.ray_from_pixel = view.image_from_local.leftCols<3>().inverse();
  return view;
}

}  // namespace

FlightOptions chio_wang_flight() {
  constexpr double kFocalMm = 152.0;
  constexpr double kPixelMm = 0.03;
  constexpr double kScale = 8000.0;
  constexpr double kFrameMm = 230.0;
  constexpr double kOverlap = 0.6;
  FlightOptions options;
  options.focal_length_px = kFocalMm / kPixelMm;
  options.height_above_ground_m = kScale * kFocalMm / 1000.0;
  options.base_to_height = (1.0 - kOverlap) * kFrameMm / kFocalMm;
  options.size_px = {Eigen::Vector2i(180, 180), Eigen::Vector2i(225, 180)};
  return options;
}

std::array<AerialView, 2> aerial_pair(const Scene& scene, const FlightOptions& options) {
  validate(options);
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const Eigen::Vector2d middle = 0.5 * scene.extent_m;
  const double half_base_m = 0.5 * options.base_to_height * options.height_above_ground_m;
  std::array<AerialView, 2> views;
  for (std::size_t i = 0; i < 2; ++i) {
    Random random({options.seed, kFlightStream, i});
    const auto draw = [&](double sigma) { return sigma * random.normal(); };
    const double side = i == 0 ? -1.0 : 1.0;
    const double z = scene.mean_terrain(middle) + options.height_above_ground_m;
    const Eigen::Vector3d nominal(middle.x() + side * half_base_m, middle.y(), z);
    const double s = options.position_sigma_m;
    const Eigen::Vector3d error_m{draw(s), draw(s), draw(s)};
    const double a = kRadPerDeg * options.attitude_sigma_deg;
    const Eigen::Vector3d angles_rad{draw(a), draw(a), draw(a)};
    views[i] = view_at(scene, options, options.size_px[i],
                       {.position_m = scene.frame.world_from_local(nominal + error_m),
                        .world_from_camera_axes = world_from_camera_axes(
                            angles_rad.x(), angles_rad.y(), angles_rad.z())});
  }
  return views;
}

std::array<double, 2> height_range_m(const Scene& scene) {
  constexpr double kWidthM = 50.0;
  constexpr double kLeastMarginM = 5.0;
  Eigen::AlignedBox1d heights;
  for (const Eigen::Vector3d& x : scene.mesh.vertices) heights.extend(x.tail<1>());
  const double height = heights.isEmpty() ? 0.0 : heights.sizes().x();
  const double low = heights.isEmpty() ? 0.0 : heights.min().x();
  const double margin_m = std::max(kLeastMarginM, 0.5 * (kWidthM - height));
  return {std::floor(scene.frame.origin_m.z() + low - margin_m),
          std::ceil(scene.frame.origin_m.z() + low + height + margin_m)};
}

std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene) {
  FlightOptions nominal;
  nominal.attitude_sigma_deg = 0.0;
  nominal.position_sigma_m = 0.0;
  nominal.size_px.fill(
      {2, 2});  // angles are the same in any window; that of a town has too many pixels
  const std::array<AerialView, 2> views = aerial_pair(scene, nominal);
  return {views[0].image_from_world, views[1].image_from_world};
}

io::LineSet classed_by_pair(io::LineSet lines, const std::array<ProjectionMatrix, 2>& pair) {
  for (io::Line& line : lines.lines) {
    line.epipolar_angle_deg =
        epipolar_angle_rad(pair, line.segment_in_world) * 180.0 / std::numbers::pi;
    line.line_class = *line.epipolar_angle_deg <= kMaxAlignedAngle_deg ? "aligned" : "not_aligned";
  }
  return lines;
}

}  // namespace ridgeline::simulate
