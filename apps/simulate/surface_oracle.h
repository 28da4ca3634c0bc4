// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/ray_scene.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::simulate {

/// Determines what each pixel of the views of a scene shows, so that any match can be judged,
/// including shadow and texture edges.
class SurfaceOracle {
 public:
  /// Where the line of sight of a pixel ends.
  struct Sight {
    Eigen::Vector3d x;       ///< local
    Eigen::Vector3d normal;  ///< unit normal, towards the camera
    int triangle = kNone;    ///< index in the mesh; kNone on the ground beyond it
  };

  /// Keeps a reference to the scene. A view is identified by its index in `views`.
  SurfaceOracle(const SyntheticScene& scene, std::vector<AerialView> views);

  [[nodiscard]] std::size_t num_views() const { return views_.size(); }

  /// The surface point that a pixel shows. Beyond the mesh this is the mean terrain; above the
  /// horizon the result is empty.
  [[nodiscard]] std::optional<Sight> seen_at(std::size_t view, const Eigen::Vector2d& x_px) const;

  /// Whether a point lies within the image and nothing lies between it and the camera, ignoring the
  /// last `tolerance_m` before the point.
  [[nodiscard]] bool visible(std::size_t view,
                             const Eigen::Vector3d& x,
                             double tolerance_m = 0.05) const;

  [[nodiscard]] Eigen::Vector2d pixel_of(std::size_t view, const Eigen::Vector3d& x) const;

  /// The pixel of view `to` that shows the same surface point as a pixel of view `from`;
  /// std::nullopt if `to` cannot see the point.
  [[nodiscard]] std::optional<Eigen::Vector2d> counterpart_of(std::size_t from,
                                                              std::size_t to,
                                                              const Eigen::Vector2d& x_px) const;

  /// Whether two pixels show the same smooth surface: the same material, object and plane.
  [[nodiscard]] bool same_surface(const Sight& a, const Sight& b) const;

 private:
  const SyntheticScene* scene_;
  std::vector<AerialView> views_;
  RayScene rays_;
};

/// How well segments of the first two views match, judged from the surfaces only.
struct VisibleVerdict {
  /// Median distance of the true counterparts of the left segment from the right line; infinite if
  /// none is visible.
  double right_distance_px = 0.0;
  double visible_share = 0.0;  ///< share of the left segment whose surface the right view sees
  double overlap_share =
      0.0;  ///< share of the left segment with its true counterpart on the right one
};

/// Follows the surface along both flanks of the left segment into the right view. An edge lies on
/// the surface of at least one of its sides; the other side may be a background far below, so the
/// better side counts. On each side, the counterparts of points close to the edge are extrapolated
/// to the edge, because it is a matter of chance which surface a pixel on the edge itself shows.
VisibleVerdict judge_match(const SurfaceOracle& oracle,
                           const Segment2& left,
                           const Segment2& right);

}  // namespace ridgeline::simulate
