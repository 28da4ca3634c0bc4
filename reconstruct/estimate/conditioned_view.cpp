// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/conditioned_view.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

struct PixelRay {
  Eigen::Vector3d origin, direction;
};

/// Ray of a pixel; the direction has unit length and either sign.
PixelRay ray(const ProjectionMatrix& image_from_object, const Eigen::Vector2d& x) {
  const Eigen::Matrix3d inverse = image_from_object.leftCols<3>().inverse();
  return {-inverse * image_from_object.col(3), (inverse * x.homogeneous()).normalized()};
}

/// Point of ray a closest to ray b; not finite for parallel rays.
Eigen::Vector3d closest_point(const PixelRay& a, const PixelRay& b) {
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

Eigen::Matrix3d ConditionedViews::fundamental(std::size_t from, std::size_t to) const {
  if (from > to) return fundamental(to, from).transpose();  // the same numbers both ways
  return fundamental_matrix(views[from].image_from_object, views[to].image_from_object);
}

ObservedLine observe(const ConditionedViews& frames,
                     std::size_t number,
                     const UncertainSegment2& segment,
                     LineCovariance form) {
  const ConditionedView& view = frames.views[number];
  ObservedLine observed;
  observed.view = number;
  observed.segment = {view.image.conditioned_from_image(segment.segment.start),
                      view.image.conditioned_from_image(segment.segment.end)};
  observed.sigma_e = segment.sigma_e_px / view.image.scale_px;
  observed.line = uncertain_line(segment, form, view.image);
  observed.plane = spherically_normalised(projection_plane(view.image_from_object, observed.line));
  return observed;
}

ConditionedViews condition(std::span<const ProjectionMatrix> cameras,
                           std::span<const std::vector<Segment2>> patch) {
  check(cameras.size() >= 2 && patch.size() == cameras.size(),
        "condition: cameras = ", cameras.size(), ", images = ", patch.size(),
        ", must be two or more, as many of each");
  std::vector<ImageConditioning> images(cameras.size());
  std::vector<std::size_t> used;  // views with segments
  for (std::size_t j = 0; j < images.size(); ++j) {
    if (patch[j].empty()) continue;
    used.push_back(j);
    images[j] = image_conditioning(patch[j]);
    check(images[j].scale_px > 0.0 && std::isfinite(images[j].scale_px),
          "condition: size of the patch in image ", j, " = ", images[j].scale_px,
          " px, must be positive");
  }
  check(used.size() >= 2, "condition: images with segments = ", used.size(), ", must be 2 or more");
  const auto& [first, second] = std::pair(used[0], used[1]);
  const PixelRay of_first = ray(cameras[first], images[first].centre_px);
  ConditionedViews frames;
  frames.object.centre_m = closest_point(of_first, ray(cameras[second], images[second].centre_px));
  check(frames.object.centre_m.allFinite(), "condition: the rays of the patch centres are parallel",
        ", must intersect");

  // The scale is the length that one radius of the patch in the first image spans at the distance
  // of the centre.
  const Eigen::Vector2d beside =
      images[first].centre_px + Eigen::Vector2d(images[first].scale_px, 0.0);
  const double sine = of_first.direction.cross(ray(cameras[first], beside).direction).norm();
  frames.object.scale_m = sine * (frames.object.centre_m - of_first.origin).norm();
  for (std::size_t j = 0; j < images.size(); ++j) {
    frames.views.push_back({conditioned_camera(cameras[j], images[j], frames.object), images[j]});
  }
  return frames;
}

}  // namespace ridgeline::reconstruct
