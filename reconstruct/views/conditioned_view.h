// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/conditioning.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace ridgeline::reconstruct {

/// A camera between the conditioned frames, in which all estimation happens.
struct ConditionedView {
  ProjectionMatrix image_from_object;
  ImageConditioning image;
};

/// Whether a point that is not at infinity lies in front of the camera, for either sign of the
/// homogeneous vector and of the matrix (Hartley and Zisserman 2004, result 6.1).
bool in_front(const ConditionedView& view, const Eigen::Vector4d& point);

/// The plane that an image shows as the line through x normal to `along`; its vector scales with the length
/// of `along`.
inline Eigen::Vector4d plane_across(const ProjectionMatrix& image_from_object,
                                    const Eigen::Vector2d& x,
                                    const Eigen::Vector2d& along) {
  return image_from_object.transpose() * Eigen::Vector3d(along.x(), along.y(), -along.dot(x));
}

/// An image segment as the estimation uses it; all members in the conditioned frames.
struct ObservedLine {
  Segment2 segment;
  double sigma_e = 0.0;  ///< standard deviation of the endpoints along the line
  UncertainLine2 line;
  UncertainPlane3 plane;  ///< projection plane, spherically normalised
};

/// The two images of a match: left (base), right.
using ObservedPair = std::array<ObservedLine, 2>;

/// The segment as the estimation uses it. Throws std::invalid_argument for a segment that uncertain_line()
/// rejects.
ObservedLine observe(const ConditionedView& view,
                     const UncertainSegment2& segment,
                     LineCovariance form);

/// The two views of a stereo pair and the conditioning they share.
struct StereoViews {
  ObjectConditioning object;
  std::array<ConditionedView, 2> views;  ///< left (base), right
};

/// The conditioning of a patch, which is given by segments of both images that show about the same area. The
/// patch gets unit size in each image and in object space. Its centre in object space is where the rays of
/// the two patch centres come closest.
/// Throws std::invalid_argument for an empty patch, or for cameras whose rays are parallel there.
StereoViews condition(std::span<const ProjectionMatrix, 2> cameras,
                      const std::array<std::span<const Segment2>, 2>& patch);

}  // namespace ridgeline::reconstruct
