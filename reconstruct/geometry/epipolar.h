// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <span>

namespace ridgeline {

/// Maps world coordinates to pixels; pixel (0,0) is the centre of the top-left pixel. The scale and
/// sign of the matrix are arbitrary.
using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

/// Homogeneous projection centre C (4, unit length): P C = 0.
Eigen::Vector4d projection_centre(const ProjectionMatrix& image_from_world);

/// Whether the matrix is finite and describes a camera whose centre is not at infinity.
bool is_central_camera(const ProjectionMatrix& image_from_world);

/// Pixel of a world point; NaN for a point in the plane of the projection centre.
Eigen::Vector2d project(const ProjectionMatrix& image_from_world,
                        const Eigen::Vector3d& x_in_world);

/// Images of both ends; not meaningful for a segment that crosses the plane of the projection
/// centre.
Segment2 project(const ProjectionMatrix& image_from_world, const Segment3& segment_in_world);

/// The point of a plane that is seen at a pixel; infinite or NaN if the plane is parallel to the
/// ray.
Eigen::Vector3d point_on_plane(const ProjectionMatrix& image_from_world,
                               const Eigen::Vector2d& x_px,
                               const Plane3& plane_in_world);

/// The camera for coordinates relative to a local origin: P_local x_local ~ P (x_local + origin).
ProjectionMatrix image_from_local(const ProjectionMatrix& image_from_world,
                                  const Eigen::Vector3d& origin_m);

/// F with x_to' F x_from = 0, of unit Frobenius norm; F x_from is the epipolar line of x_from in
/// the image `to` (Hartley and Zisserman 2004, section 9.2.2). It is meaningful only for central
/// cameras with different projection centres.
Eigen::Matrix3d fundamental_matrix(const ProjectionMatrix& from, const ProjectionMatrix& to);

/// Distance of y from the epipolar line of x (F x) in the image of y.
double epipolar_distance_px(const Eigen::Matrix3d& fundamental,
                            const Eigen::Vector2d& x,
                            const Eigen::Vector2d& y);

/// By default, a line is `aligned` if its angle to its epipolar line is at most this (Ok et al.
/// 2011, section 3).
inline constexpr double kMaxAlignedAngle_deg = 10.0;

/// Angle in [0, pi/2] between a segment of the image `own` and the epipolar line through its
/// midpoint (the join of midpoint and epipole) that belongs to the image `other`.
double epipolar_angle_rad(const ProjectionMatrix& own,
                          const ProjectionMatrix& other,
                          const Segment2& segment_in_own);

/// The smaller of the epipolar angles of the two segments of a match.
double epipolar_angle_rad(const std::array<ProjectionMatrix, 2>& cameras,
                          const Segment2& left,
                          const Segment2& right);

/// Angle in [0, pi/2] between a line seen by a pair of cameras and the epipolar line through its
/// midpoint, the smaller of the angles in both images; a line is `aligned` up to 10 degrees (Ok et
/// al. 2011, section 3; combining the two images in this way is ours).
/// With more than two cameras, the largest angle of all pairs is returned, because the best pair is
/// decisive. Throws std::invalid_argument for fewer than two cameras.
double epipolar_angle_rad(std::span<const ProjectionMatrix> image_from_world,
                          const Segment3& segment_in_world);

}  // namespace ridgeline
