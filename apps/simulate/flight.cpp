// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/flight.h"

#include "apps/simulate/random.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ridgeline::simulate {
namespace {

constexpr std::uint64_t kFlightStream = 0x666c69676874;

/// The pixels of the full frame, whose principal point is pixel (0, 0), that show the plan.
Eigen::AlignedBox2d frame_window(const SyntheticScene& scene,
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

/// Limits the memory for grey values, the file size and the run time.
void check_num_pixels(const Eigen::Vector2d& size_px) {
  constexpr double kMaxPixels = 3e8;
  check(size_px.prod() <= kMaxPixels, "images of ", size_px.x(), " x ", size_px.y(),
        " pixels; must be of 300 megapixels at most: choose smaller frames, a smaller extent, a "
        "greater camera height or no images");
}

void check_frame_size(const Eigen::Vector2i& size_px) {
  check(size_px.minCoeff() >= kMinFrameSide_px && size_px.maxCoeff() <= kMaxFrameSide_px,
        "frame_px = ", size_px.x(), ",", size_px.y(), ", must be in [", kMinFrameSide_px, ", ",
        kMaxFrameSide_px, "] each");
}

/// Position of an image in the full frame, whose principal point is pixel (0, 0).
struct RenderedWindow {
  Eigen::Vector2d corner_px;  ///< the top-left pixel
  Eigen::Vector2i size_px;
};

/// The actual pose of a view, with the errors of the flight.
ExteriorOrientation flown(const SyntheticScene& scene,
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

/// The whole frame, or the part of it that shows the plan.
RenderedWindow window_of(const SyntheticScene& scene,
                         const FlightOptions& options,
                         const PlannedView& planned,
                         const ProjectionMatrix& frame_from_world) {
  if (options.frame_px) {
    check_num_pixels(options.frame_px->cast<double>());
    return {-0.5 * (options.frame_px->cast<double>() - Eigen::Vector2d::Ones()), *options.frame_px};
  }
  Eigen::AlignedBox2d window = frame_window(scene, frame_from_world, options.margin_m);
  if (!options.size_px.empty()) {
    const Eigen::Vector2i& size_px = options.size_px[planned.number];
    const Eigen::Vector2d corner = (window.center() - 0.5 * size_px.cast<double>()).array().round();
    const Eigen::Vector2i steps = size_px - Eigen::Vector2i::Ones();
    window = {corner, corner + steps.cast<double>()};
  }
  const Eigen::Vector2d corner_px = window.min().array().floor();
  const Eigen::Vector2d last_px = (window.max() - corner_px).array().ceil();
  check_num_pixels(last_px);
  return {corner_px, last_px.cast<int>().array() + 1};
}

/// The pixels of a frame around the image of the mesh, with a small margin because edge sides are
/// sampled slightly beyond an edge.
Eigen::AlignedBox2i pixels_of_mesh(const Mesh& mesh, const AerialView& view) {
  constexpr double kBeside_px = 4.0;
  Eigen::AlignedBox2d seen_px;
  for (const Eigen::Vector3d& x : mesh.vertices) seen_px.extend(project(view.image_from_local, x));
  if (seen_px.isEmpty()) return {};
  const Eigen::AlignedBox2d frame_px(Eigen::Vector2d::Zero(),
                                     view.size_px.cast<double>() - Eigen::Vector2d::Ones());
  const Eigen::Vector2d beside_px = Eigen::Vector2d::Constant(kBeside_px);
  const Eigen::AlignedBox2d shown_px =
      Eigen::AlignedBox2d(seen_px.min() - beside_px, seen_px.max() + beside_px)
          .intersection(frame_px);
  if (shown_px.isEmpty()) return {};
  return {shown_px.min().array().floor().cast<int>(), shown_px.max().array().ceil().cast<int>()};
}

/// Rays near the horizon do not meet the ground, or only too far away for the landscape to be
/// treated as a plane.
void check_looks_down(const SyntheticScene& scene, const AerialView& view) {
  constexpr double kMinSinking = 0.1;  // descent per distance: ground ten flying heights away
  const Eigen::Vector2d last_px = view.size_px.cast<double>() - Eigen::Vector2d::Ones();
  for (const double column : {0.0, last_px.x()}) {
    for (const double row : {0.0, last_px.y()}) {
      const Eigen::Vector3d ray = view.ray({column, row});
      const double sinking = scene.mean_terrain.gradient.dot(ray.head<2>()) - ray.z();
      check(std::min(sinking, -ray.z()) >= kMinSinking, "frames of ", view.size_px.x(), " x ",
            view.size_px.y(), " pixels: ", view.id,
            " looks at the horizon; choose smaller frames, a smaller tilt or a greater focal "
            "length");
    }
  }
}

void check_shows_middle(const SyntheticScene& scene, const AerialView& view) {
  const Eigen::Vector2d middle = 0.5 * scene.extent_m;
  const Eigen::Vector2d x_px =
      project(view.image_from_local, {middle.x(), middle.y(), scene.mean_terrain(middle)});
  const Eigen::AlignedBox2d frame_px(Eigen::Vector2d::Zero(),
                                     view.size_px.cast<double>() - Eigen::Vector2d::Ones());
  check(frame_px.contains(x_px), "frames of ", view.size_px.x(), " x ", view.size_px.y(),
        " pixels: ", view.id,
        " does not show the middle of the plan; choose larger frames, fewer views in a strip or a "
        "smaller base");
}

AerialView aerial_view(const SyntheticScene& scene,
                       const FlightOptions& options,
                       const PlannedView& planned) {
  InteriorOrientation interior;
  interior.focal_length_px.setConstant(options.focal_length_px);
  const ExteriorOrientation exterior = flown(scene, options, planned);
  const ProjectionMatrix frame_from_world = projection_matrix(interior, exterior);
  const RenderedWindow window = window_of(scene, options, planned, frame_from_world);
  AerialView view;
  view.id = planned.id;
  view.number = planned.number;
  view.size_px = window.size_px;
  view.interior = interior;
  view.interior.principal_point_px = -window.corner_px;
  view.interior.size_px = window.size_px;
  view.exterior = exterior;
  view.image_from_world = window_from_world(frame_from_world, window.corner_px);
  view.image_from_local = image_from_local(view.image_from_world, scene.frame.origin_m);
  view.centre_in_local = scene.frame.local_from_world(exterior.position_m);
  view.ray_from_pixel = view.image_from_local.leftCols<3>().inverse();
  if (options.frame_px) {
    check_looks_down(scene, view);
    view.village_px = pixels_of_mesh(scene.mesh, view);
  } else {
    view.village_px = {Eigen::Vector2i::Zero(), view.size_px - Eigen::Vector2i::Ones()};
  }
  return view;
}

}  // namespace

std::vector<AerialView> aerial_views(const SyntheticScene& scene,
                                     const FlightOptions& options,
                                     std::span<const PlannedView> planned) {
  validate(options);
  check(options.size_px.empty() || options.size_px.size() == planned.size(), "size_px has ",
        options.size_px.size(), " sizes for ", planned.size(),
        " views; must have one for each or none");
  check(options.size_px.empty() || !options.frame_px, "size_px and frame_px, must not both be set");
  if (options.frame_px) check_frame_size(*options.frame_px);
  std::vector<AerialView> views;
  std::ranges::transform(planned, std::back_inserter(views), [&](const PlannedView& view) {
    return aerial_view(scene, options, view);
  });
  return views;
}

std::vector<AerialView> aerial_views(const SyntheticScene& scene, const FlightOptions& options) {
  std::vector<AerialView> views = aerial_views(scene, options, planned_views(options));
  if (!options.frame_px) return views;
  for (const AerialView& view : views) check_shows_middle(scene, view);
  return views;
}

std::array<double, 2> height_range_m(const SyntheticScene& scene) {
  constexpr double kWidthM = 50.0;
  constexpr double kMinMarginM = 5.0;
  Eigen::AlignedBox1d heights;
  for (const Eigen::Vector3d& x : scene.mesh.vertices) heights.extend(x.tail<1>());
  const double height = heights.isEmpty() ? 0.0 : heights.sizes().x();
  const double low = heights.isEmpty() ? 0.0 : heights.min().x();
  const double margin_m = std::max(kMinMarginM, 0.5 * (kWidthM - height));
  return {std::floor(scene.frame.origin_m.z() + low - margin_m),
          std::ceil(scene.frame.origin_m.z() + low + height + margin_m)};
}

std::array<ProjectionMatrix, 2> nominal_pair(const SyntheticScene& scene) {
  FlightOptions nominal;
  nominal.attitude_sigma_deg = 0.0;
  nominal.position_sigma_m = 0.0;
  // the angles are the same in any window, and a window for a town would have too many pixels
  nominal.size_px = {{2, 2}, {2, 2}};
  const std::vector<AerialView> views = aerial_views(scene, nominal);
  return {views[0].image_from_world, views[1].image_from_world};
}

void set_class(std::span<const ProjectionMatrix> image_from_world, io::Line& line) {
  line.epipolar_angle_deg =
      deg_from_rad(epipolar_angle_rad(image_from_world, line.segment_in_world));
  line.line_class = *line.epipolar_angle_deg <= kMaxAlignedAngle_deg ? "aligned" : "not_aligned";
}

io::LineSet classed_by_views(io::LineSet lines,
                             std::span<const ProjectionMatrix> image_from_world) {
  for (io::Line& line : lines.lines) set_class(image_from_world, line);
  return lines;
}

}  // namespace ridgeline::simulate
