// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/aerial_cameras.h"
#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/scene_model.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::other {

/// A straight edge that at least two photographs show.
struct TrueEdge {
  Edge edge;  ///< from the first to the last point that any one of `views` shows
  /// The photographs, by their places from 0, of which at least one other one shows it as well.
  std::vector<std::size_t> views;
  std::vector<double> visible;  ///< share of `edge` that each of `views` shows
  /// From the first to the last point that each of the first two photographs shows; nothing unless
  /// both are enough to tell where the edge is.
  std::optional<std::array<Segment2, 2>> base_px;
};

/// Whether the ground is of different patches on both sides of an edge at `x`.
bool is_ground_border(const Scene& scene, const Segment3& edge, const Eigen::Vector3d& x);

/// Straight borders of the shadows that edges of the scene throw on its faces. Kind: shadow.
std::vector<Edge> shadow_edges(const Scene& scene, const RayTracer& tracer);

/// The edges of which two photographs show enough to tell where they are, found by a ray to a point
/// every 4 cm: each one 6 px and a quarter of what they show between them. Parts of edges of the
/// ground where no other patch begins are taken for hidden.
std::vector<TrueEdge> true_edges(const Scene& scene,
                                 const RayTracer& tracer,
                                 const std::vector<AerialCamera>& cameras,
                                 const std::vector<Edge>& edges);

}  // namespace ridgeline::other
