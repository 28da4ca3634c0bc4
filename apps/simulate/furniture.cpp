// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/furniture.h"

#include "apps/simulate/mesh_builder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::simulate {
namespace {

/// A direction uniformly distributed on the unit sphere (Archimedes: z is uniform).
Eigen::Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1.0, 1.0);
  const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

ConvexPolygon turned_rectangle(const Eigen::Vector2d& centre,
                               double azimuth_rad,
                               double half_u,
                               double half_v) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(azimuth_rad).toRotationMatrix();
  ConvexPolygon polygon = rectangle({-half_u, -half_v}, {half_u, half_v});
  for (Eigen::Vector2d& x : polygon) x = turn * x + centre;
  return polygon;
}

ConvexPolygon body_of(const Car& car) {
  return turned_rectangle(car.foot.head<2>(), car.azimuth_rad, car.half_length_m, car.half_width_m);
}

ConvexPolygon cabin_of(const Car& car) {
  return turned_rectangle(car.foot.head<2>(), car.azimuth_rad, car.cabin_half_length_m,
                          car.cabin_half_width_m);
}

}  // namespace

void add_tree(const Eigen::Vector3d& foot,
              double crown_radius_m,
              double height_m,
              Random& random,
              Mesh& mesh) {
  constexpr double kOpticalDepth = 1.6;  // mean number of leaves on a vertical ray
  constexpr double kLeafM = 0.22;
  constexpr double kLeafAreaM2 = 1.3 * kLeafM * kLeafM;  // equilateral, circumradius kLeafM
  constexpr double kMeanCosine = 0.5;                    // over random orientations
  const double crown_height = std::min(0.75 * height_m, 2.6 * crown_radius_m);
  const Eigen::Vector3d centre = foot + Eigen::Vector3d(0.0, 0.0, height_m - 0.5 * crown_height);
  // semi-axes for the centres of the leaves, so that their tips stay within the crown
  const Eigen::Vector3d half_axes(crown_radius_m - kLeafM, crown_radius_m - kLeafM,
                                  0.5 * crown_height - kLeafM);
  const double shadow_m2 = std::numbers::pi * crown_radius_m * crown_radius_m;
  const int count = static_cast<int>(kOpticalDepth * shadow_m2 / (kMeanCosine * kLeafAreaM2));
  // bulges make the crown rough: the radius varies with direction
  const SurfaceAppearance leaf{kNone, kNone, Material::kFoliage, next_object_id(mesh)};
  const Eigen::Vector3d wave{random.uniform(2.0, 4.0), random.uniform(2.0, 4.0),
                             random.uniform(2.0, 4.0)};
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d direction = random_direction(random);
    const double bulge = 0.85 + 0.15 * std::sin(wave.dot(direction) * std::numbers::pi);
    const double radius = bulge * std::cbrt(random.uniform(0.15, 1.0));
    const Eigen::Vector3d x = centre + radius * half_axes.cwiseProduct(direction);
    const Eigen::Vector3d normal = random_direction(random);
    const Eigen::Vector3d a = kLeafM * normal.unitOrthogonal();
    const Eigen::Vector3d b = normal.cross(a);
    const double half_sqrt3 = 0.5 * std::numbers::sqrt3;
    add_polygon({x + a, x - 0.5 * a + half_sqrt3 * b, x - 0.5 * a - half_sqrt3 * b}, leaf, mesh);
  }
  constexpr double kHalfTrunkM = 0.12;
  add_prism(turned_rectangle(foot.head<2>(), 0.0, kHalfTrunkM, kHalfTrunkM), foot.z() - 0.5,
            centre.z(), {kNone, kNone, Material::kWood, leaf.object_id}, mesh);
}

void add_car(const Car& car, Mesh& mesh) {
  const SurfaceAppearance look{kNone, kNone, Material::kCar, next_object_id(mesh)};
  const double foot_z = car.foot.z();
  add_prism(body_of(car), foot_z - 0.1, foot_z + car.bonnet_m, look, mesh);
  add_prism(cabin_of(car), foot_z + car.bonnet_m, foot_z + car.roof_m, look, mesh);
}

std::vector<Segment3> edges_of(const Car& car) {
  std::vector<Segment3> edges;
  const auto add_sides = [&](const ConvexPolygon& outline, double z) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d& a = outline[i];
      const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
      edges.push_back({{a.x(), a.y(), z}, {b.x(), b.y(), z}});
    }
  };
  add_sides(body_of(car), car.foot.z() + car.bonnet_m);
  add_sides(cabin_of(car), car.foot.z() + car.roof_m);
  return edges;
}

}  // namespace ridgeline::simulate
