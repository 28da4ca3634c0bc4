// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/conditioning.h"

#include <Eigen/Geometry>

namespace ridgeline {

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
