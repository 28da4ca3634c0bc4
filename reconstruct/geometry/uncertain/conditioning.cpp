// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/conditioning.h"

#include <Eigen/Geometry>

namespace ridgeline {

Vector6d conditioned_from_local(const ObjectConditioning& object, const Vector6d& line_in_local) {
  const Eigen::Vector3d direction = line_in_local.head<3>();
  Vector6d line;
  line << direction, (line_in_local.tail<3>() - object.centre_m.cross(direction)) / object.scale_m;
  return line;
}

Eigen::Vector4d conditioned_from_local(const ObjectConditioning& object,
                                       const Eigen::Vector4d& plane_in_local) {
  Eigen::Vector4d plane;
  plane << object.scale_m * plane_in_local.head<3>(),
      plane_in_local.head<3>().dot(object.centre_m) + plane_in_local.w();
  return plane;
}

ProjectionMatrix conditioned_camera(const ProjectionMatrix& image_from_local,
                                    const ImageConditioning& image,
                                    const ObjectConditioning& object) {
  ProjectionMatrix p;
  p << object.scale_m * image_from_local.leftCols<3>(),
      image_from_local * object.centre_m.homogeneous();
  p.topRows<2>() = ((p.topRows<2>() - image.centre_px * p.row(2)) / image.scale_px).eval();
  return p / p.norm();
}

}  // namespace ridgeline
