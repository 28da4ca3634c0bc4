// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/edge_model.h"
#include "evaluate/scan/scan_edges.h"

#include <array>
#include <vector>

namespace ridgeline::evaluate {

/// An edge while it is being found.
struct FoundEdge {
  ScanEdge edge;
  EdgeModel model;
  double spacing_m = 0.0;  ///< of the points of its planes
  int level = 0;           ///< edges of different levels have no common corner: roof, top of a rim
  std::array<double, 2> along_m2{};  ///< variance of its ends along it
};

/// Moves the ends of edges that meet to their common corner: the point nearest to their lines,
/// weighted by their accuracy. An end whose line does not pass through the corner within 3 sigma
/// or 10 cm stays on its line, at the foot of the corner.
void meet_at_corners(std::vector<FoundEdge>& edges);

}  // namespace ridgeline::evaluate
