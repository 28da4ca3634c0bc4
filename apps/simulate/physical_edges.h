// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <string>
#include <vector>

namespace ridgeline::simulate {

/// A straight edge of the surfaces of a scene, where two of them meet or one ends; local metres.
struct PhysicalEdge {
  Segment3 segment{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::string
      kind;      ///< kind of the true line it lies on; else joint, foot, or material: gutter, ...
  int rank = 0;  ///< 0: true line, 1: joint, 2: other; of coinciding edges the lowest counts
};

/// All true lines, joints, borders of the polygons of the mesh (leaves left out) and lines where
/// walls and fences stand on the ground. Pieces that continue or overlap each other are merged, so
/// that each edge has its full length once. Some edges cannot be seen, because they lie
/// inside a body or between two tiles of one lawn. The order is fixed.
std::vector<PhysicalEdge> physical_edges(const SyntheticScene& scene);

}  // namespace ridgeline::simulate
