// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/aerial_cameras.h"
#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/scene_model.h"

#include <array>
#include <vector>

namespace ridgeline::other {

/// A straight edge that both photographs show.
struct TrueEdge {
  Edge edge;                           ///< from the first to the last point that either one shows
  std::array<double, 2> visible{};     ///< share of `edge` that the left and the right one show
  std::array<Segment2, 2> visible_px;  ///< from the first to the last point that each shows
};

/// Straight borders of the shadows that edges of the scene throw on its faces. Kind: shadow.
std::vector<Edge> shadow_edges(const Scene& scene, const RayTracer& tracer);

/// The edges of which both photographs show something, found by a ray to a point every 4 cm. Parts
/// of edges of the ground where no other patch begins are taken for hidden.
std::vector<TrueEdge> true_edges(const Scene& scene,
                                 const RayTracer& tracer,
                                 const std::array<AerialCamera, 2>& cameras,
                                 const std::vector<Edge>& edges);

}  // namespace ridgeline::other
