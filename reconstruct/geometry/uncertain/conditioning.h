// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>

namespace ridgeline {

/// Translation and scale that bring a patch of object space to unit size, so that the components of
/// homogeneous vectors have comparable magnitudes: x_in_conditioned = (x_in_local - centre) /
/// scale.
struct ObjectConditioning {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double scale_m = 1.0;

  [[nodiscard]] Eigen::Vector3d conditioned_from_local(const Eigen::Vector3d& x) const {
    return (x - centre_m) / scale_m;
  }
  [[nodiscard]] Eigen::Vector3d local_from_conditioned(const Eigen::Vector3d& x) const {
    return scale_m * x + centre_m;
  }
};

/// Translation and scale that bring a patch of an image to unit size: x_in_conditioned = (x_px -
/// centre) / scale.
struct ImageConditioning {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  double scale_px = 1.0;

  [[nodiscard]] Eigen::Vector2d conditioned_from_image(const Eigen::Vector2d& x) const {
    return (x - centre_px) / scale_px;
  }
  [[nodiscard]] Eigen::Vector2d image_from_conditioned(const Eigen::Vector2d& x) const {
    return scale_px * x + centre_px;
  }
};

/// K P T^-1: the camera between the two conditioned frames, scaled to unit Frobenius norm.
ProjectionMatrix conditioned_camera(const ProjectionMatrix& image_from_local,
                                    const ImageConditioning& image,
                                    const ObjectConditioning& object);

}  // namespace ridgeline
