// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/flight.h"

#include "apps/simulate/planned_views.h"
#include "apps/simulate/random.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
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
      const Eigen::Vector3d corner =
          scene.frame.world_from_local(Eigen::Vector3d(x, y, scene.mean_terrain({x, y})));
      const double depth_m = frame_from_world.row(2) * corner.homogeneous();
      check(depth_m > 0.0,
            "the plan reaches behind a view; choose a smaller extent, a smaller tilt "
            "or a greater camera height");
      window.extend(project(frame_from_world, corner));
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

/// Where a view is in fact, with the errors of the flight.
ExteriorOrientation flown(const Scene& scene,
                          const FlightOptions& options,
                          const PlannedView& planned) {
  Random random({options.seed, kFlightStream, planned.number});
  const auto draw = [&](double sigma) { return sigma * random.normal(); };
  const double s = options.position_sigma_m;
  const Eigen::Vector3d error_m{draw(s), draw(s), draw(s)};
  const double a = kRadPerDeg * options.attitude_sigma_deg;
  const Eigen::Vector3d angles_rad{draw(a), draw(a), draw(a)};
  const Eigen::Vector2d middle = 0.5 * scene.extent_m;
  const Eigen::Vector3d on_ground(middle.x(), middle.y(), scene.mean_terrain(middle));
  return {.position_m = scene.frame.world_from_local(on_ground + planned.from_middle_m + error_m),
          .world_from_camera_axes =
              planned.world_from_camera_axes *
              world_from_camera_axes(angles_rad.x(), angles_rad.y(), angles_rad.z())};
}

AerialView aerial_view(const Scene& scene,
                       const FlightOptions& options,
                       const PlannedView& planned) {
  InteriorOrientation interior;
  interior.focal_length_px.setConstant(options.focal_length_px);
  const ExteriorOrientation exterior = flown(scene, options, planned);
  const ProjectionMatrix frame_from_world = projection_matrix(interior, exterior);
  Eigen::AlignedBox2d window = frame_window(scene, frame_from_world, options.margin_m);
  if (!options.size_px.empty()) {
    const Eigen::Vector2i& size_px = options.size_px[planned.number];
    const Eigen::Vector2d corner = (window.center() - 0.5 * size_px.cast<double>()).array().round();
    const Eigen::Vector2i steps = size_px - Eigen::Vector2i::Ones();
    window = {corner, corner + steps.cast<double>()};
  }
  const Eigen::Vector2d corner_px = window.min().array().floor();

  AerialView view;
  view.id = planned.id;
  view.number = planned.number;
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

std::vector<AerialView> aerial_views(const Scene& scene, const FlightOptions& options) {
  validate(options);
  const std::vector<PlannedView> planned = planned_views(options);
  check(options.size_px.empty() || options.size_px.size() == planned.size(), "size_px has ",
        options.size_px.size(), " sizes for ", planned.size(),
        " views; must have one for each or none");
  std::vector<AerialView> views;
  std::ranges::transform(planned, std::back_inserter(views), [&](const PlannedView& view) {
    return aerial_view(scene, options, view);
  });
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
  // angles are the same in any window; that of a town has too many pixels
  nominal.size_px = {{2, 2}, {2, 2}};
  const std::vector<AerialView> views = aerial_views(scene, nominal);
  return {views[0].image_from_world, views[1].image_from_world};
}

io::LineSet classed_by_views(io::LineSet lines,
                             std::span<const ProjectionMatrix> image_from_world) {
  for (io::Line& line : lines.lines) {
    line.epipolar_angle_deg =
        epipolar_angle_rad(image_from_world, line.segment_in_world) * 180.0 / std::numbers::pi;
    line.line_class = *line.epipolar_angle_deg <= kMaxAlignedAngle_deg ? "aligned" : "not_aligned";
  }
  return lines;
}

}  // namespace ridgeline::simulate
