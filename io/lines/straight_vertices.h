// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace ridgeline::io {

/// Vertices of one connected line, in the file's CRS.
using Vertices = std::vector<Eigen::Vector3d>;

/// How far a vertex may lie beside a straight line for it to be no bend, in units of the file: two
/// of the last digit where coordinates are rounded to hundredths.
inline constexpr double kStraightTolerance = 0.02;

/// The vertices at which a polyline bends, with its ends (Douglas-Peucker): every other one lies
/// within kStraightTolerance of the segment that remains. A closed ring whose first vertex is no
/// bend begins at the first that is one. A polyline with coordinates that are not finite, or of
/// fewer than three vertices, stays as it is.
Vertices bends_of(const Vertices& vertices);

}  // namespace ridgeline::io
