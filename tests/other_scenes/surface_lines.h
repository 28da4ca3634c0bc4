// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/scene_model.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::other {

/// A straight edge with the surfaces on which a laser scan from above may have points.
struct SurfaceLine {
  Segment3 segment;
  /// That of the edge, but: foot, where a wall meets the ground or a lower roof; wall_top, of
  /// garden walls; object, of cars, chimneys and fences.
  std::string kind;
  std::vector<int> faces;  ///< whose planes it lies on; none for object
};

/// The surfaces of an edge or of a part of it; nothing for edges on walls alone.
std::optional<SurfaceLine> with_surfaces(const Scene& scene, const Edge& edge);

/// Of each edge in the patch the longest stretch that something above sees, from straight above to
/// 35 degrees from it, with its surfaces. Stretches below 0.5 m are left out.
std::vector<SurfaceLine> surface_lines(const Scene& scene, const RayTracer& tracer);

}  // namespace ridgeline::other
