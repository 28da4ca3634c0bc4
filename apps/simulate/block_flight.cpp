// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/block_flight.h"

#include "apps/simulate/village.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::simulate {
namespace {

/// Geometry of the block on level ground.
struct StripPlan {
  Eigen::Vector2d frame_m;  ///< area shown by a frame: along the strip, across it
  double base_m;            ///< distance between the frames of a strip
  double spacing_m;         ///< distance between the strips
};

StripPlan plan_of(const BlockOptions& block, const FlightOptions& flight) {
  validate(block);
  validate(flight);
  check(block.num_strips >= 1 && block.num_strips <= kMaxStripsOrFrames,
        "strips of a block = ", block.num_strips, ", must be in [1, ", kMaxStripsOrFrames, "]");
  check(block.num_frames >= 2 && block.num_frames <= kMaxStripsOrFrames,
        "frames of a strip = ", block.num_frames, ", must be in [2, ", kMaxStripsOrFrames, "]");
  check(flight.frame_px.has_value(), "a block, must have whole frames");
  const double pixel_m = flight.height_above_ground_m / flight.focal_length_px;
  const Eigen::Vector2d frame_m = pixel_m * flight.frame_px->cast<double>();
  return {frame_m, (1.0 - block.forward_overlap) * frame_m.x(),
          (1.0 - block.side_overlap) * frame_m.y()};
}

/// The extent shown by two frames of each strip.
Eigen::Vector2d shown_twice_m(const BlockOptions& block, const StripPlan& plan) {
  return {plan.frame_m.x() + (block.num_frames - 3) * plan.base_m,
          plan.frame_m.y() + (block.num_strips - 1) * plan.spacing_m};
}

/// The margin by which a frame may show less of the objects at its border than of level ground.
Eigen::Vector2d margin_m(const StripPlan& plan,
                         const FlightOptions& flight,
                         double terrain_slope_deg) {
  constexpr double kMaxObjectHeight_m = 15.0;  // of houses and trees
  constexpr double kSigmas = 4.0;
  const double height_m = flight.height_above_ground_m;
  const Eigen::Vector2d half_m = 0.5 * plan.frame_m;
  const double slope = std::tan(kRadPerDeg * terrain_slope_deg);
  const Eigen::Vector2d relief_m = slope * half_m + Eigen::Vector2d::Constant(kMaxObjectHeight_m);
  const double sigma_rad = kRadPerDeg * flight.attitude_sigma_deg;
  const double sigma_m = std::hypot(flight.position_sigma_m, sigma_rad * height_m,  // omega, phi
                                    sigma_rad * half_m.norm());                     // kappa
  return half_m.cwiseProduct(relief_m) / height_m + Eigen::Vector2d::Constant(kSigmas * sigma_m);
}

/// Number of frames in a strip along y, so that two of them show each place that the strips along x
/// show.
int num_cross_frames(const BlockOptions& block, const StripPlan& plan) {
  const double steps = (shown_twice_m(block, plan).y() - plan.frame_m.x()) / plan.base_m;
  constexpr double kRounding = 1e-9;
  return std::max(2, static_cast<int>(std::ceil(steps - kRounding)) + 3);
}

/// Strips in one direction.
struct Strips {
  int num_strips;
  int num_frames;
  double azimuth_rad;  ///< angle of the flight to the x axis
  double shift_m;      ///< shift of all frames to the right of the flight
};

double from_middle(int i, int count) { return i - 0.5 * (count - 1); }

/// Adds the frames of strips, whose numbering continues after `num_before` other strips.
void add_strips(const Strips& strips,
                const StripPlan& plan,
                int num_before,
                std::vector<PlannedView>& views) {
  const Eigen::Rotation2Dd plan_from_flight(strips.azimuth_rad);
  for (int s = 0; s < strips.num_strips; ++s) {
    const double there_or_back = s % 2 == 0 ? 1.0 : -1.0;
    for (int i = 0; i < strips.num_frames; ++i) {
      const double along_m = there_or_back * plan.base_m * from_middle(i, strips.num_frames);
      const double across_m = plan.spacing_m * from_middle(s, strips.num_strips);
      PlannedView view;
      view.id = fmt::format("{:02}_{:02}", num_before + s + 1, i + 1);
      view.number = views.size();
      view.from_middle_m.head<2>() =
          plan_from_flight * Eigen::Vector2d(along_m, across_m - strips.shift_m);
      const double kappa_rad = strips.azimuth_rad + (there_or_back > 0.0 ? 0.0 : std::numbers::pi);
      view.world_from_camera_axes = world_from_camera_axes(0.0, 0.0, kappa_rad);
      views.push_back(std::move(view));
    }
  }
}

/// The lowest and the highest heights of a scene above the mean terrain.
Eigen::AlignedBox1d heights_above_terrain_m(const SyntheticScene& scene) {
  Eigen::AlignedBox1d heights_m(Eigen::Matrix<double, 1, 1>::Zero());
  for (const Eigen::Vector3d& x : scene.mesh.vertices) {
    heights_m.extend(Eigen::Matrix<double, 1, 1>(x.z() - scene.mean_terrain(x.head<2>())));
  }
  return heights_m;
}

bool shows(const AerialView& view, const Eigen::Vector3d& x) {
  const Eigen::Vector2d x_px = project(view.image_from_local, x);
  const Eigen::Vector2d last_px = view.size_px.cast<double>() - Eigen::Vector2d::Ones();
  return (x_px.array() >= 0.0).all() && (x_px.array() <= last_px.array()).all();
}

}  // namespace

Eigen::Vector2d block_extent_m(const BlockOptions& block,
                               const FlightOptions& flight,
                               double terrain_slope_deg) {
  const StripPlan plan = plan_of(block, flight);
  Eigen::Vector2d extent_m =
      (shown_twice_m(block, plan) - 2.0 * margin_m(plan, flight, terrain_slope_deg))
          .array()
          .floor();
  check((extent_m.array() >= kMinExtent_m).all() && (extent_m.array() <= kMaxExtent_m).all(),
        "two frames of each strip of the block show ", extent_m.x(), " x ", extent_m.y(),
        " m, must be ", kMinExtent_m, " to ", kMaxExtent_m,
        " m each; choose other numbers of strips and frames, another size of the frames or another "
        "camera height");
  return extent_m;
}

std::vector<PlannedView> block_views(const BlockOptions& block,
                                     const FlightOptions& flight,
                                     const SyntheticScene& scene) {
  // so that no frame of a strip along y coincides with one of a strip along x
  constexpr double kCrossShiftBases = 0.25;
  const StripPlan plan = plan_of(block, flight);
  std::vector<PlannedView> views;
  add_strips({block.num_strips, block.num_frames, 0.0, 0.0}, plan, 0, views);
  add_strips({block.num_cross_strips, num_cross_frames(block, plan), 0.5 * std::numbers::pi,
              kCrossShiftBases * plan.base_m},
             plan, block.num_strips, views);
  for (PlannedView& view : views) {
    view.from_middle_m.z() = flight.height_above_ground_m +
                             scene.mean_terrain.gradient.dot(view.from_middle_m.head<2>());
  }
  return views;
}

void check_shown_twice(const SyntheticScene& scene,
                       std::span<const AerialView> views,
                       const Eigen::AlignedBox2d& area_m) {
  constexpr double kStep_m = 5.0;
  const Eigen::AlignedBox1d heights_m = heights_above_terrain_m(scene);
  const Eigen::Array2i steps = (area_m.sizes() / kStep_m).array().ceil().cast<int>();
  for (int i = 0; i <= steps.x(); ++i) {
    for (int k = 0; k <= steps.y(); ++k) {
      const Eigen::Vector2d share = Eigen::Array2d(i, k) / steps.cast<double>();
      const Eigen::Vector2d at = area_m.min() + share.cwiseProduct(area_m.sizes());
      for (const double height_m : {heights_m.min().x(), heights_m.max().x()}) {
        const Eigen::Vector3d x(at.x(), at.y(), scene.mean_terrain(at) + height_m);
        const auto num_views =
            std::ranges::count_if(views, [&](const AerialView& view) { return shows(view, x); });
        check(num_views >= 2, "the place ", at.x(), ", ", at.y(),
              " m from the corner of the plan, ", height_m, " m above the ground, is shown by ",
              num_views,
              " frames, must be 2 or more; choose larger overlaps, smaller errors of the flight, a "
              "flatter terrain or larger frames");
      }
    }
  }
}

}  // namespace ridgeline::simulate
