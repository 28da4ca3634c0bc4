// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/track.h"
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

/// The plane whose image is the line through x normal to `along`; its vector scales with the length
/// of `along`.
inline Eigen::Vector4d plane_across(const ProjectionMatrix& image_from_object,
                                    const Eigen::Vector2d& x,
                                    const Eigen::Vector2d& along) {
  return image_from_object.transpose() * Eigen::Vector3d(along.x(), along.y(), -along.dot(x));
}

/// An image segment as used in the estimation; all members in the conditioned frames.
struct ObservedLine {
  std::size_t view = 0;  ///< index of the view that shows it
  Segment2 segment;
  double sigma_e = 0.0;  ///< standard deviation of the endpoints along the line
  UncertainLine2 line;
  UncertainPlane3 plane;  ///< projection plane, spherically normalised
};

using ObservedTrack = TrackOf<ObservedLine>;

/// The views of a scene and the conditioning they share.
struct ConditionedViews {
  ObjectConditioning object;
  std::vector<ConditionedView> views;

  /// The view that shows a line.
  [[nodiscard]] const ConditionedView& of(const ObservedLine& seen) const {
    return views[seen.view];
  }
  /// F of two of the conditioned images, with x_to' F x_from = 0.
  [[nodiscard]] Eigen::Matrix3d fundamental(std::size_t from, std::size_t to) const;
};

/// A segment of a view as used in the estimation. Throws std::invalid_argument for a segment that
/// uncertain_line() rejects.
ObservedLine observe(const ConditionedViews& frames,
                     std::size_t view,
                     const UncertainSegment2& segment,
                     LineCovariance form);

/// The conditioning of a patch, which is given by segments of all images that show about the same
/// area. The patch gets unit size in each image and in object space. Images without segments keep
/// their pixel coordinates. Its centre in object space is where the rays of the patch centres of
/// the first two images with segments come closest. Throws std::invalid_argument for fewer than two
/// images with segments, and for cameras whose rays are parallel there.
ConditionedViews condition(std::span<const ProjectionMatrix> cameras,
                           std::span<const std::vector<Segment2>> patch);

}  // namespace ridgeline::reconstruct
