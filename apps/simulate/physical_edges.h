// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <string>
#include <vector>

namespace ridgeline::simulate {

/// A straight edge where two surfaces of a scene meet or one ends; local metres.
struct PhysicalEdge {
  Segment3 segment{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::string kind;  ///< kind of the true line it lies on; otherwise joint, foot, or a material:
                     ///< gutter, ...
  int rank = 0;  ///< 0: true line, 1: joint, 2: other; of coinciding edges, the one with the lowest
                 ///< rank is kept
};

/// All true lines, joints, borders of mesh polygons (except leaves) and lines where walls and
/// fences meet the ground. Pieces that continue or overlap each other are merged, so that each edge
/// occurs once, in its full length. Some edges are never visible, because they lie inside a body or
/// between two tiles of one lawn. The order is deterministic.
std::vector<PhysicalEdge> physical_edges(const SyntheticScene& scene);

}  // namespace ridgeline::simulate
