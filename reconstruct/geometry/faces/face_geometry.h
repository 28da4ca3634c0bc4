// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace ridgeline {

/// The plane of a face by its outer ring, which need not be flat; its normal as the ring turns.
/// Nothing if the ring has no area or is not finite.
std::optional<Plane3> plane_of(const Face& face);

/// Whether a face that states nothing is a wall: steeper than 80 degrees.
bool is_wall(const Plane3& plane);

/// Whether a point of the plane of a face lies within the face and none of its holes. `x` is
/// projected along the largest axis of the normal.
bool is_on_face(const Face& face, const Plane3& plane, const Eigen::Vector3d& x);

/// The direction in a face, across an edge at its middle, to the inside of the face, a unit vector;
/// nothing if the face lies on both sides of the edge, or on none.
std::optional<Eigen::Vector3d> inward_of(const Face& face,
                                         const Plane3& plane,
                                         const Segment3& edge);

/// The vertices of a ring in thousandths, in an order that depends neither on its start nor on its
/// direction.
using Outline = std::vector<std::array<double, 3>>;
Outline outline_of(const Ring& ring);

}  // namespace ridgeline
