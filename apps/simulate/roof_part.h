// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// A convex body with a roof: top height = minimum of its planes over a convex outline. A roof of
/// any shape is the upper envelope of such parts, so all its lines follow from exact intersections
/// of half-planes.
struct RoofPart {
  ConvexPolygon outline;           ///< outline of the roof, with the overhang
  std::vector<PlanFunction> tops;  ///< height of each plane
  ConvexPolygon walls;             ///< outline of the walls, set back below the roof
  std::vector<bool> is_joint;      ///< sides of the outline that meet another part; may be empty
  double base_z_m = 0.0;           ///< where the walls end, below the ground
  double slab_thickness_m = 0.0;   ///< vertical; 0: the walls reach the top
  int building_id = 0;
  PlaneKind kind = PlaneKind::kRoof;
};

/// One plane of one part, restricted to where it is the lowest of its part.
struct PartFace {
  int part = 0;
  int plane_id = 0;  ///< index into SyntheticScene::planes
  PlanFunction height;
  LabelledPolygon cell;  ///< label >= 0: side of the outline; -1 - k: border to plane k of the part
  int top = 0;           ///< index into RoofPart::tops
};

/// The faces of all parts, with ids starting at `first_plane_id`.
std::vector<PartFace> roof_faces(std::span<const RoofPart> parts, int first_plane_id);

/// Adds the planes, lines, joints, faces and triangles of parts that may touch each other but no
/// other part of the scene.
void add_structure(std::span<const RoofPart> parts, SyntheticScene& scene);

}  // namespace ridgeline::simulate
