// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/flank_strips.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace ridgeline::test {

using reconstruct::FlankStrip;
using reconstruct::FlankStrips;

/// Aperiodic texture of the plan, details of `size_m`, values about 0.3 to 0.7; another one per seed.
inline double plan_texture(const Eigen::Vector2d& x_m, double size_m, std::uint64_t seed) {
  const auto lattice = [seed](std::int64_t i, std::int64_t k) {
    std::uint64_t h = seed + 0x9E3779B97F4A7C15ULL * static_cast<std::uint64_t>(i + 100000);
    h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9ULL + static_cast<std::uint64_t>(k + 100000);
    h = (h ^ (h >> 27U)) * 0x94D049BB133111EBULL;
    return 0.3 + 0.4 * static_cast<double>((h ^ (h >> 31U)) >> 11U) * 0x1.0p-53;
  };
  const Eigen::Vector2d x = x_m / size_m;
  const auto i = static_cast<std::int64_t>(std::floor(x.x()));
  const auto k = static_cast<std::int64_t>(std::floor(x.y()));
  const double u = x.x() - static_cast<double>(i);
  const double v = x.y() - static_cast<double>(k);
  return (1 - v) * ((1 - u) * lattice(i, k) + u * lattice(i + 1, k)) +
         v * ((1 - u) * lattice(i, k + 1) + u * lattice(i + 1, k + 1));
}

/// The strips that the cameras of a scene see beside a line: on one side of it a surface that it
/// bounds, on the other one the ground.
struct FlankedLine {
  StereoScene scene;
  Segment3 line;
  double roof_slope = 0.0;     ///< of the surface, downwards from the line
  double ground_m = 0.0;       ///< height of the ground
  bool has_ground = true;      ///< else the surface goes on, as beside a ridge
  bool roof_is_plain = false;  ///< without texture
  double gain_right = 1.0;     ///< of the grey values of the right image
  double last_seen_x_px = std::numeric_limits<double>::infinity();  ///< border of the right image
  bool right_runs_back = false;

  [[nodiscard]] FlankStrips strips() const {
    const std::array<Segment2, 2> images = scene.images(line);
    FlankStrips both;
    both.left = strip(0, images[0], 0.0, 1.0, FlankStrip::kLeftStep_px);
    const Segment2 right = right_runs_back ? Segment2{images[1].end, images[1].start} : images[1];
    constexpr double kBeyond_px = 60.0;
    const double beyond = kBeyond_px / length(right);
    both.right = strip(1, right, -beyond, 1.0 + beyond, FlankStrip::kRightStep_px);
    return both;
  }

 private:
  [[nodiscard]] FlankStrip strip(
      std::size_t view, const Segment2& image, double from, double to, double step_px) const {
    const Eigen::Vector2d along = image.end - image.start;
    const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()).normalized();
    FlankStrip strip;
    strip.axis = {image.start + from * along, image.start + to * along};
    strip.n_along = static_cast<int>((to - from) * along.norm() / step_px) + 1;
    strip.n_bands = 1;
    for (const std::size_t side : {0U, 1U}) {
      for (int row = 0; row < FlankStrip::kRows; ++row) {
        const double offset =
            (side == 0 ? 1.0 : -1.0) * (FlankStrip::kFirstRow_px + row * FlankStrip::kRowStep_px);
        for (int i = 0; i < strip.n_along; ++i) {
          const double t = static_cast<double>(i) / (strip.n_along - 1);
          const Eigen::Vector2d x =
              strip.axis.start + t * (strip.axis.end - strip.axis.start) + offset * across;
          strip.sides[side].push_back(seen(view, x));
        }
      }
    }
    return strip;
  }

  [[nodiscard]] float seen(std::size_t view, const Eigen::Vector2d& x) const {
    if (view == 1 && x.x() > last_seen_x_px) return std::numeric_limits<float>::quiet_NaN();
    const Eigen::Vector3d direction = (line.end - line.start).normalized();
    const Eigen::Vector3d sideways = Eigen::Vector3d::UnitZ().cross(direction).normalized() -
                                     roof_slope * Eigen::Vector3d::UnitZ();
    const Plane3 roof(direction.cross(sideways).normalized(), line.start);
    const Eigen::Vector3d on_roof = point_on_plane(scene.cameras[view], x, roof);
    const bool on_this_side =
        (on_roof - line.start).dot(Eigen::Vector3d::UnitZ().cross(direction)) > 0.0;
    const double gain = view == 1 ? gain_right : 1.0;
    if (on_this_side || !has_ground) {
      return static_cast<float>(roof_is_plain ? gain * 0.5
                                              : gain * plan_texture(on_roof.head<2>(), 0.4, 1));
    }
    const Plane3 ground(Eigen::Vector3d::UnitZ(), -ground_m);
    return static_cast<float>(
        gain * plan_texture(point_on_plane(scene.cameras[view], x, ground).head<2>(), 0.4, 2));
  }
};

}  // namespace ridgeline::test
