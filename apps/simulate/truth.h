// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "io/cloud/point_cloud.h"

#include <vector>

namespace ridgeline::simulate {

/// A true line with what can be observed of it from above.
struct TruthLine {
  int id = 0;                  ///< index into SyntheticScene::lines
  double visible_share = 0.0;  ///< share of its length (0..1) that nothing covers, not even a tree
  std::vector<int> plane_returns;  ///< for each plane, laser returns on it within 1.5 m of the line
};

/// Returns one result per true line, in order of SyntheticScene::lines. A laser return is on a
/// plane if it lies within 0.15 m of it and, in plan, inside its outline. Throws
/// std::invalid_argument unless the cloud is in the frame of the scene; an empty cloud gives zero
/// returns.
std::vector<TruthLine> observe_lines(const SyntheticScene& scene, const io::PointCloud& cloud);

}  // namespace ridgeline::simulate
