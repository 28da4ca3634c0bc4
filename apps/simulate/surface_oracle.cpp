// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/surface_oracle.h"

#include "reconstruct/geometry/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace ridgeline::simulate {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  return upper_median(std::move(values));
}

}  // namespace

SurfaceOracle::SurfaceOracle(const SyntheticScene& scene, std::vector<AerialView> views)
    : scene_(&scene), views_(std::move(views)), rays_(scene.mesh) {}

std::optional<SurfaceOracle::Sight> SurfaceOracle::seen_at(std::size_t view,
                                                           const Eigen::Vector2d& x_px) const {
  const Eigen::Vector3d& origin = views_[view].centre_in_local;
  const Eigen::Vector3d direction = views_[view].ray(x_px);
  if (const auto hit = rays_.first_hit(origin, direction)) {
    const Eigen::Vector3d normal = triangle_normal(scene_->mesh, hit->triangle);
    return Sight{origin + hit->distance_m * direction,
                 normal.dot(direction) > 0.0 ? Eigen::Vector3d(-normal) : normal, hit->triangle};
  }
  const Plane3 ground = plane_of(scene_->mean_terrain);
  if (ground.normal().dot(direction) >= 0.0) return std::nullopt;
  const double distance_m = -ground.signedDistance(origin) / ground.normal().dot(direction);
  return Sight{origin + distance_m * direction, ground.normal(), kNone};
}

bool SurfaceOracle::visible(std::size_t view, const Eigen::Vector3d& x, double tolerance_m) const {
  const Eigen::Vector2d x_px = pixel_of(view, x);
  const Eigen::Vector2i& size = views_[view].size_px;
  if ((x_px.array() < -0.5).any() || (x_px.array() > size.cast<double>().array() - 0.5).any()) {
    return false;
  }
  const Eigen::Vector3d to_camera = (views_[view].centre_in_local - x).normalized();
  return !rays_.occluded(x, to_camera, tolerance_m);
}

Eigen::Vector2d SurfaceOracle::pixel_of(std::size_t view, const Eigen::Vector3d& x) const {
  return project(views_[view].image_from_local, x);
}

std::optional<Eigen::Vector2d> SurfaceOracle::counterpart_of(std::size_t from,
                                                             std::size_t to,
                                                             const Eigen::Vector2d& x_px) const {
  const auto sight = seen_at(from, x_px);
  if (!sight || !visible(to, sight->x)) return std::nullopt;
  return pixel_of(to, sight->x);
}

bool SurfaceOracle::same_surface(const Sight& a, const Sight& b) const {
  constexpr double kSameDirection = 0.9999;
  constexpr double kSamePlaneM = 0.02;
  const auto look = [&](const Sight& sight) {
    const Triangle beyond;  // lawn beyond the mesh
    const Triangle& t = sight.triangle == kNone
                            ? beyond
                            : scene_->mesh.triangles[static_cast<std::size_t>(sight.triangle)];
    return std::tuple(t.material, t.building_id, t.object_id);
  };
  return look(a) == look(b) && a.normal.dot(b.normal) > kSameDirection &&
         std::abs(a.normal.dot(b.x - a.x)) < kSamePlaneM;
}

VisibleVerdict judge_match(const SurfaceOracle& oracle,
                           const Segment2& left,
                           const Segment2& right) {
  constexpr double kStepPx = 2.0;
  constexpr double kNearPx = 0.4;  // two distances from the edge, both within a fence of 0.1 m
  constexpr double kFarPx = 0.8;
  constexpr double kBeyondPx = 3.0;  // endpoints of segments are not exact
  const Eigen::Vector2d left_normal = normal(left);
  const Eigen::Vector2d right_normal = normal(right);
  const Eigen::Vector2d right_along = along(right);
  const int samples = 1 + static_cast<int>(length(left) / kStepPx);
  std::array<std::vector<double>, 2> distances_px;
  std::array<int, 2> overlapping{};
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector2d x = left.start + (i + 0.5) / samples * (left.end - left.start);
    for (const std::size_t side : {0U, 1U}) {
      const Eigen::Vector2d n = side == 0 ? left_normal : Eigen::Vector2d(-left_normal);
      const auto near = oracle.counterpart_of(0, 1, x + kNearPx * n);
      const auto far = oracle.counterpart_of(0, 1, x + kFarPx * n);
      if (!near || !far) continue;
      const Eigen::Vector2d on_edge = *near - kNearPx / (kFarPx - kNearPx) * (*far - *near);
      distances_px[side].push_back(std::abs(right_normal.dot(on_edge - right.start)));
      const double position = right_along.dot(on_edge - right.start);
      overlapping[side] += position >= -kBeyondPx && position <= length(right) + kBeyondPx ? 1 : 0;
    }
  }
  const std::array<double, 2> medians{median(distances_px[0]), median(distances_px[1])};
  const std::size_t best = medians[0] <= medians[1] ? 0 : 1;
  return {.right_distance_px = medians[best],
          .visible_share = static_cast<double>(distances_px[best].size()) / samples,
          .overlap_share = static_cast<double>(overlapping[best]) / samples};
}

}  // namespace ridgeline::simulate
