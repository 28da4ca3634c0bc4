// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::simulate {

struct SurfaceAppearance {
  int building_id = kNone;
  int plane_id = kNone;
  Material material = Material::kGround;
  int object_id = kNone;
};

/// An id that no other object of the mesh has: the number of its first vertex.
inline int next_object_id(const Mesh& mesh) { return static_cast<int>(mesh.vertices.size()); }

/// Adds a convex planar polygon (counter-clockwise seen from outside) as a fan of triangles; fewer
/// than three corners add nothing.
void add_polygon(const std::vector<Eigen::Vector3d>& corners,
                 const SurfaceAppearance& look,
                 Mesh& mesh);

/// Adds the top and sides, but no bottom, of a body with vertical walls between two heights.
void add_prism(const ConvexPolygon& outline,
               double low_z,
               double high_z,
               const SurfaceAppearance& look,
               Mesh& mesh);

}  // namespace ridgeline::simulate
