// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::io {

/// The plane of a face by Newell's method over its outer ring, which need not be flat; normal as the ring turns. Nothing if
/// the ring has no area or is not finite.
std::optional<Plane3> plane_of(const ModelFace& face);

/// Whether a face that states nothing is a wall: steeper than 80 degrees.
bool is_wall(const Plane3& plane);

/// What each face of a building is: as the file states, or by geometry where it does not. A face without a plane is kOther. Of
/// faces without a statement, those steeper than 80 degrees are walls, and of the others those with another such face above them are the
/// ground. `planes`: plane_of() each face.
std::vector<SurfaceKind> roles_of(std::span<const ModelFace> faces,
                                  std::span<const std::optional<Plane3>> planes);

/// The roles of all faces of a model, which has those of a building together.
std::vector<SurfaceKind> roles_of(const BuildingModel& model);

/// Whether a point of the plane of a face lies within the face and none of its holes. `x` is projected along the largest axis of the
/// normal.
bool is_on_face(const ModelFace& face, const Plane3& plane, const Eigen::Vector3d& x);

/// The direction in a face, across an edge at its middle, to the inside of the face, a unit vector; nothing if the face lies on both sides
/// of the edge, or on none.
std::optional<Eigen::Vector3d> inward_of(const ModelFace& face,
                                         const Plane3& plane,
                                         const Segment3& edge);

}  // namespace ridgeline::io
