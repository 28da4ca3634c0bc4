// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::test {

/// Ridges, hips and valleys of the roofs in the points of buildings (local, m), found without the
/// judge: from planes fitted to whole roofs, not to the surroundings of a line.
/// Buildings are connected cells of a 1 m grid. Each is cut into planes by sequential RANSAC and
/// least squares; two planes that differ by 10 degrees or more meet in a line, which is kept where
/// both have points beside it, if that is at least 3 m long.
std::vector<Segment3> roof_ridges(const std::vector<Eigen::Vector3d>& points);

}  // namespace ridgeline::test
