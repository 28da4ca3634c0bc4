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

/// The plane of a face, from its outer ring, which need not be flat. Seen from the tip of the
/// normal, the ring runs counter-clockwise. std::nullopt if the ring has no area or is not finite.
std::optional<Plane3> plane_of(const Face& face);

/// Whether a face of unknown kind is a wall: steeper than 80 degrees.
bool is_wall(const Plane3& plane);

/// Whether a point on the plane of a face lies within the face and outside its holes. `x` is
/// projected along the largest axis of the normal.
bool is_on_face(const Face& face, const Plane3& plane, const Eigen::Vector3d& x);

/// The unit vector in the plane of a face that points from the middle of an edge, perpendicular to
/// it, into the face; std::nullopt if the face lies on both sides of the edge, or on neither.
std::optional<Eigen::Vector3d> inward_of(const Face& face,
                                         const Plane3& plane,
                                         const Segment3& edge);

/// The vertices of a ring, rounded to thousandths of the unit, in an order that depends neither on
/// its start nor on its direction.
using Outline = std::vector<std::array<double, 3>>;
Outline outline_of(const Ring& ring);

}  // namespace ridgeline
