// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/aerial_pair.h"
#include "apps/simulate/ray_scene.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace ridgeline::simulate {

/// Knows what any pixel of two views of a scene shows, so that any match can be judged: edges of
/// shadows and textures too.
class SurfaceOracle {
 public:
  enum View : std::size_t { kLeft, kRight };

  /// Where the line of sight of a pixel ends.
  struct Sight {
    Eigen::Vector3d x;       ///< local
    Eigen::Vector3d normal;  ///< unit normal, towards the camera
    int triangle = kNone;    ///< index in the mesh; kNone on the ground beyond it
  };

  /// Keeps a reference to the scene; `views` are copied.
  SurfaceOracle(const Scene& scene, const std::array<AerialView, 2>& views);

  /// What a pixel shows. Beyond the mesh it shows the mean terrain; above the horizon the result is empty.
  [[nodiscard]] std::optional<Sight> seen_at(View view, const Eigen::Vector2d& x_px) const;

  /// Whether nothing lies between a point and the camera, but for the last `tolerance_m` before
  /// the point, and the point falls in the image.
  [[nodiscard]] bool visible(View view, const Eigen::Vector3d& x, double tolerance_m = 0.05) const;

  [[nodiscard]] Eigen::Vector2d pixel_of(View view, const Eigen::Vector3d& x) const;

  /// The right pixel that shows the same surface point as a left pixel; nothing where the point
  /// cannot be seen in the right view.
  [[nodiscard]] std::optional<Eigen::Vector2d> right_of(const Eigen::Vector2d& left_px) const;

  /// Whether two pixels show one smooth surface: the same material, object and plane.
  [[nodiscard]] bool same_surface(const Sight& a, const Sight& b) const;

 private:
  const Scene* scene_;
  std::array<AerialView, 2> views_;
  RayScene rays_;
};

/// How well a pair of image segments shows the same thing, by the surfaces alone.
struct MatchVerdict {
  /// Median distance of the true mates of the left segment to the right line; infinite where none
  /// can be seen.
  double right_distance_px = 0.0;
  double visible_share = 0.0;  ///< share of the left segment whose surface the right view sees
  double overlap_share = 0.0;  ///< share of the left segment with its true mate on the right one
};

/// Follows the surface along both flanks of the left segment into the right view. An edge lies on
/// the surface of one of its sides at least; the other may be a background far below, so the better
/// side counts. On each side the mates of the points close beside the edge are extrapolated to the edge.
/// At the edge itself it is chance which surface a pixel shows.
MatchVerdict judge_match(const SurfaceOracle& oracle, const Segment2& left, const Segment2& right);

}  // namespace ridgeline::simulate
