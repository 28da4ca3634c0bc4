// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/epipolar.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline {

Eigen::Vector4d projection_centre(const ProjectionMatrix& image_from_world) {
  // The rows are normalised so that the null vector does not depend on the scale of a row.
  const ProjectionMatrix p = image_from_world.rowwise().normalized();
  return null_vector<4>(p);
}

Eigen::Vector2d project(const ProjectionMatrix& image_from_world,
                        const Eigen::Vector3d& x_in_world) {
  const Eigen::Vector3d x = image_from_world * x_in_world.homogeneous();
  if (x.z() == 0.0) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  return x.hnormalized();
}

Segment2 project(const ProjectionMatrix& image_from_world, const Segment3& segment_in_world) {
  return {project(image_from_world, segment_in_world.start),
          project(image_from_world, segment_in_world.end)};
}

Eigen::Vector3d point_on_plane(const ProjectionMatrix& image_from_world,
                               const Eigen::Vector2d& x_px,
                               const Plane3& plane_in_world) {
  const Eigen::Matrix3d rays_from_pixels = image_from_world.leftCols<3>().inverse();
  const Eigen::Vector3d centre = -rays_from_pixels * image_from_world.col(3);
  const Eigen::Vector3d ray = rays_from_pixels * x_px.homogeneous();
  const double t = -plane_in_world.signedDistance(centre) / plane_in_world.normal().dot(ray);
  return centre + t * ray;
}

bool is_central_camera(const ProjectionMatrix& image_from_world) {
  constexpr double kMinVolume =
      1e-9;  // spanned by the rows: in pixels they differ by the focal length
  const Eigen::Matrix3d rows = image_from_world.leftCols<3>().rowwise().normalized();
  return image_from_world.allFinite() && std::abs(rows.determinant()) > kMinVolume;
}

ProjectionMatrix image_from_local(const ProjectionMatrix& image_from_world,
                                  const Eigen::Vector3d& origin_m) {
  ProjectionMatrix p = image_from_world;
  p.col(3) = image_from_world * origin_m.homogeneous();
  return p;
}

Eigen::Matrix3d fundamental_matrix(const ProjectionMatrix& from, const ProjectionMatrix& to) {
  // F = S(e) M_to M_from^-1 uses the transfer by the plane at infinity. Using P_from^+ instead
  // would square the condition number.
  const Eigen::Matrix3d transfer = to.leftCols<3>() * from.leftCols<3>().inverse();
  const Eigen::Vector3d epipole = to.col(3) - transfer * from.col(3);
  Eigen::Matrix3d f;
  for (int column = 0; column < 3; ++column) f.col(column) = epipole.cross(transfer.col(column));
  return f.normalized();
}

double epipolar_distance_px(const Eigen::Matrix3d& fundamental,
                            const Eigen::Vector2d& x,
                            const Eigen::Vector2d& y) {
  const Eigen::Vector3d line = fundamental * x.homogeneous();
  return std::abs(line.dot(y.homogeneous())) / line.head<2>().norm();
}

double epipolar_angle_rad(const ProjectionMatrix& own,
                          const ProjectionMatrix& other,
                          const Segment2& segment_in_own) {
  // The direction of the join of x and e at x is e_xy - e_w x, which also holds for an epipole at
  // infinity.
  const Eigen::Vector3d epipole = own * projection_centre(other);
  return acute_angle_rad(
      Eigen::Vector2d(segment_in_own.end - segment_in_own.start),
      Eigen::Vector2d(epipole.head<2>() - epipole.z() * midpoint(segment_in_own)));
}

double epipolar_angle_rad(const std::array<ProjectionMatrix, 2>& cameras,
                          const Segment2& left,
                          const Segment2& right) {
  return std::min(epipolar_angle_rad(cameras[0], cameras[1], left),
                  epipolar_angle_rad(cameras[1], cameras[0], right));
}

double epipolar_angle_rad(std::span<const ProjectionMatrix> image_from_world,
                          const Segment3& segment_in_world) {
  check(image_from_world.size() >= 2, "epipolar_angle_rad: cameras = ", image_from_world.size(),
        ", must be at least 2");
  double largest = 0.0;
  for (std::size_t i = 0; i < image_from_world.size(); ++i) {
    for (std::size_t k = i + 1; k < image_from_world.size(); ++k) {
      const ProjectionMatrix& pi = image_from_world[i];
      const ProjectionMatrix& pk = image_from_world[k];
      largest = std::max(largest, epipolar_angle_rad({pi, pk}, project(pi, segment_in_world),
                                                     project(pk, segment_in_world)));
    }
  }
  return largest;
}

}  // namespace ridgeline
