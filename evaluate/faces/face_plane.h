// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_points.h"
#include "evaluate/faces/options.h"
#include "evaluate/judge/plane_fit.h"
#include "evaluate/judge/point_normals.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// The plane of the points over a face: of the planes that search_planes() finds in them and that are like the face's own
/// (FaceOptions::max_height_m at its centroid, max_tilt_deg), the one with the most points. Points near the outline are
/// left out. It is fitted anew to the points within JudgeOptions::inlier_distance_m until these stay the same.
/// @param points  points_around() of the face
/// @return nothing if no such plane holds JudgeOptions::min_points
std::optional<PlaneFit> fit_face_plane(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const FaceOptions& options,
                                       const PointNormals& normals = {});

/// Whether a point is one of those that a face's plane is fitted to, if it lies on the plane.
bool is_well_inside(const FacePoint& point, const FaceOptions& options);

/// Whether a point lies on a plane.
bool is_on(const Plane3& plane, const FacePoint& point, const FaceOptions& options);

}  // namespace ridgeline::evaluate
