// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_points.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/plane_fit.h"
#include "evaluate/judge/point_normals.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// The plane of the points over a face: of the planes that search_planes() finds in them and that
/// are similar to the face's own (kMaxFaceHeight_m at its centroid, kMaxFaceTilt_deg), the one with
/// the most points. Points near the outline are left out. It is refitted to the points within
/// JudgeOptions::inlier_distance_m until these stay the same; its sigma0 is untruncated_sigma_m().
/// @param points  points_around() of the face
/// @return empty if no such plane holds JudgeOptions::min_points
std::optional<PlaneFit> find_face_plane(std::span<const FacePoint> points,
                                        const RoofFace& face,
                                        const JudgeOptions& options,
                                        const PointNormals& normals = {});

/// The plane refitted without the points that may also belong to a neighbour: those that also lie
/// on the neighbour's plane and within kFaceReach_m of the neighbour. If a face extends across the
/// ridge, the points beyond the ridge would otherwise tilt its plane. Nearly identical planes
/// (kMinAngleOfRidge_deg) share their points.
/// @return `fit` itself if too few points remain
PlaneFit refit_face_plane(std::span<const FacePoint> points,
                          const PlaneFit& fit,
                          std::span<const NeighbourFace> neighbours,
                          const JudgeOptions& options);

/// The standard deviation from which a plane's uncertainty follows if its n points were kept
/// because they lie within `limit_m` of it. With k = limit / sigma and g = 1 - 2 k phi(k) / (2
/// Phi(k) - 1), normal residuals truncated at the limit have the standard deviation sqrt(g) sigma,
/// and a plane fitted to them with repeated truncation has the uncertainty of a plane with
/// residuals 1 / g times as large (the skipped mean in Huber and Ronchetti, Robust Statistics,
/// 2009, section 4). At k = 3 this factor is 1.03; below k = 1.5 the normal distribution is not a
/// valid model, and the factor stays at 1.81.
/// @param truncated_m  standard deviation of the points that were kept
double untruncated_sigma_m(double truncated_m, double limit_m);

/// Whether a point is among those to which a face's plane is fitted if it lies on the plane.
bool is_well_inside(const FacePoint& point);

/// Whether a point lies on a plane.
bool is_on(const Plane3& plane, const FacePoint& point, const JudgeOptions& options);

/// Whether two planes are nearly identical, so that points cannot distinguish them.
bool are_nearly_one(const Plane3& a, const Plane3& b);

}  // namespace ridgeline::evaluate
