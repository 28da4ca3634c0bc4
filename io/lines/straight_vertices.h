// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace ridgeline::io {

/// Vertices of one connected line, in the file's CRS.
using Vertices = std::vector<Eigen::Vector3d>;

/// Maximum distance from a straight line at which a vertex is not a bend, in units of the file: two
/// units of the last digit if coordinates are rounded to hundredths.
inline constexpr double kStraightTolerance = 0.02;

/// The vertices at which a polyline bends, with its ends (Douglas-Peucker): every other vertex lies
/// within kStraightTolerance of the remaining segment. A closed ring whose first vertex is not a
/// bend begins at its first bend. A polyline with coordinates that are not finite, or with fewer
/// than three vertices, is returned unchanged.
Vertices bends_of(const Vertices& vertices);

}  // namespace ridgeline::io
