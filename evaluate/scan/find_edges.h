// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/neighbours.h"
#include "evaluate/scan/scan_edges.h"

#include <Eigen/Core>

#include <span>

namespace ridgeline::evaluate {

struct ScanOptions {
  /// The points are those of roofs alone, without ground: a roof then ends where they end. Without
  /// it, that is the end of the scan, which is no edge.
  bool only_roofs = false;
};

/// The planes of a scan and the edges of its roofs. The result does not depend on the order of the
/// points. Points that are not finite, and further points at the same position, are ignored.
/// @param search  gets the points in ascending order of (x, y, z); all exact searches give the same
/// result
ScanEdges find_edges(std::span<const Eigen::Vector3d> points_in_local,
                     const ScanOptions& options = {},
                     const NeighbourSearch& search = nearest_neighbours);

}  // namespace ridgeline::evaluate
