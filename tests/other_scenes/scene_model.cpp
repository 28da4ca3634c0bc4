// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/scene_model.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ridgeline::other {
namespace {

struct Interval {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Stretch of the line x + t d, which lies in the plane of the face, that is inside of the face.
Interval inside(const Face& face, const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
  const Eigen::Vector3d normal = normal_of(face);
  Interval t;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Eigen::Vector3d& corner = face.corners[i];
    const Eigen::Vector3d side = face.corners[(i + 1) % face.corners.size()] - corner;
    const Eigen::Vector3d inward = normal.cross(side).normalized();
    const double distance_m = inward.dot(x - corner);
    const double rate = inward.dot(d);
    if (std::abs(rate) < 1e-9) {
      if (distance_m < 0.0) return {1.0, 0.0};
    } else if (rate > 0.0) {
      t.from = std::max(t.from, -distance_m / rate);
    } else {
      t.to = std::min(t.to, -distance_m / rate);
    }
  }
  return t;
}

}  // namespace

Eigen::Vector2d in_patch(const GroundPatch& patch, const Eigen::Vector2d& x) {
  const Eigen::Vector2d across(-patch.along.y(), patch.along.x());
  return {patch.along.dot(x - patch.centre), across.dot(x - patch.centre)};
}

int patch_at(const Scene& scene, const Eigen::Vector2d& x) {
  for (int i = static_cast<int>(scene.ground.size()) - 1; i >= 0; --i) {
    const Eigen::Vector2d own = in_patch(scene.ground[i], x);
    if ((own.cwiseAbs().array() <= scene.ground[i].half_size.array()).all()) return i;
  }
  return -1;
}

Eigen::Vector3d normal_of(const Face& face) {
  return (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]).normalized();
}

Segment3 common_segment(const Face& a, const Face& b) {
  const Eigen::Vector3d normal_a = normal_of(a);
  const Eigen::Vector3d normal_b = normal_of(b);
  const Eigen::Vector3d direction = normal_a.cross(normal_b);
  if (direction.norm() < 1e-3) return {a.corners[0], a.corners[0]};
  Eigen::Matrix3d planes;
  planes << normal_a.transpose(), normal_b.transpose(), direction.transpose();
  const Eigen::Vector3d offsets(normal_a.dot(a.corners[0]), normal_b.dot(b.corners[0]),
                                direction.dot(a.corners[0]));
  const Eigen::Vector3d x = planes.inverse() * offsets;
  const Eigen::Vector3d d = direction.normalized();
  const Interval in_a = inside(a, x, d);
  const Interval in_b = inside(b, x, d);
  const double from = std::max(in_a.from, in_b.from);
  const double to = std::min(in_a.to, in_b.to);
  if (!(to > from)) return {a.corners[0], a.corners[0]};
  return {x + from * d, x + to * d};
}

}  // namespace ridgeline::other
