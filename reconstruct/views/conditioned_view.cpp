// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/views/conditioned_view.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

struct Ray {
  Eigen::Vector3d origin, direction;
};

/// Ray of a pixel; the direction has unit length and either sign.
Ray ray(const ProjectionMatrix& image_from_object, const Eigen::Vector2d& x) {
  const Eigen::Matrix3d inverse = image_from_object.leftCols<3>().inverse();
  return {-inverse * image_from_object.col(3), (inverse * x.homogeneous()).normalized()};
}

/// Point of ray a closest to ray b; not finite for parallel rays.
Eigen::Vector3d closest_point(const Ray& a, const Ray& b) {
  const Eigen::Vector3d normal = a.direction.cross(b.direction);
  const double distance =
      (b.origin - a.origin).cross(b.direction).dot(normal) / normal.squaredNorm();
  return a.origin + distance * a.direction;
}

/// The centre is the mean of the midpoints, the scale is the largest distance of an end from it.
ImageConditioning image_conditioning(std::span<const Segment2> patch) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Segment2& segment : patch) sum += midpoint(segment);
  ImageConditioning image{.centre_px = sum / static_cast<double>(patch.size()), .scale_px = 0.0};
  for (const Segment2& segment : patch) {
    image.scale_px = std::max({image.scale_px, (segment.start - image.centre_px).norm(),
                               (segment.end - image.centre_px).norm()});
  }
  return image;
}

}  // namespace

bool in_front(const ConditionedView& view, const Eigen::Vector4d& point) {
  const double depth = view.image_from_object.row(2).dot(point);
  return depth * point.w() * view.image_from_object.leftCols<3>().determinant() > 0.0;
}

ObservedLine observe(const ConditionedView& view,
                     const UncertainSegment2& segment,
                     LineCovariance form) {
  ObservedLine observed;
  observed.segment = {view.image.conditioned_from_image(segment.segment.start),
                      view.image.conditioned_from_image(segment.segment.end)};
  observed.sigma_e = segment.sigma_e_px / view.image.scale_px;
  observed.line = uncertain_line(segment, form, view.image);
  observed.plane = spherically_normalised(projection_plane(view.image_from_object, observed.line));
  return observed;
}

StereoViews condition(std::span<const ProjectionMatrix, 2> cameras,
                      const std::array<std::span<const Segment2>, 2>& patch) {
  std::array<ImageConditioning, 2> images;
  for (std::size_t j = 0; j < 2; ++j) {
    check(!patch[j].empty(), "condition: segments in image ", j, " = 0, must be at least 1");
    images[j] = image_conditioning(patch[j]);
    check(images[j].scale_px > 0.0 && std::isfinite(images[j].scale_px),
          "condition: size of the patch in image ", j, " = ", images[j].scale_px,
          " px, must be positive");
  }
  const Ray left = ray(cameras[0], images[0].centre_px);
  StereoViews stereo;
  stereo.object.centre_m = closest_point(left, ray(cameras[1], images[1].centre_px));
  check(stereo.object.centre_m.allFinite(),
        "condition: the rays of the patch's centres are parallel", ", must intersect");

  // The scale is what one radius of the patch in the left image spans at the distance of the centre.
  const Eigen::Vector2d beside = images[0].centre_px + Eigen::Vector2d(images[0].scale_px, 0.0);
  const double sine = left.direction.cross(ray(cameras[0], beside).direction).norm();
  stereo.object.scale_m = sine * (stereo.object.centre_m - left.origin).norm();
  for (std::size_t j = 0; j < 2; ++j) {
    stereo.views[j] = {conditioned_camera(cameras[j], images[j], stereo.object), images[j]};
  }
  return stereo;
}

}  // namespace ridgeline::reconstruct
