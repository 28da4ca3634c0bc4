// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "io/cloud/point_cloud.h"

#include <vector>

namespace ridgeline::simulate {

/// A true line with what an observer from above can know of it.
struct TruthLine {
  int id = 0;                      ///< index into SyntheticScene::lines
  double visible_share = 0.0;      ///< share of length (0..1) that nothing covers, not even a tree
  std::vector<int> plane_returns;  ///< per plane: laser returns on it within 1.5 m of the line
};

/// Gives one result per true line, in order of SyntheticScene::lines. A return counts as on a plane
/// if it lies within 0.15 m of it and, in plan, inside its outline. The cloud must be in the frame
/// of the scene, else std::invalid_argument; an empty cloud gives zero returns.
std::vector<TruthLine> observe_lines(const SyntheticScene& scene, const io::PointCloud& cloud);

}  // namespace ridgeline::simulate
