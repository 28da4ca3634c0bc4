// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/surroundings.h"

#include "tests/other_scenes/solids.h"

#include <array>
#include <cmath>

namespace ridgeline::other {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A frustum over a rectangle: the cabin of a car, its sides glass.
void add_cabin(Solids& solids, const Vector3d& middle, const Look& roof) {
  const Look glass{Material::kGlass, Vector3d(0.05, 0.06, 0.07), 4};
  const auto corner = [&](int i, double half_x, double half_y, double z) {
    const double sx = i == 1 || i == 2 ? 1.0 : -1.0;
    const double sy = i >= 2 ? 1.0 : -1.0;
    return Vector3d(middle + Vector3d(sx * half_x, sy * half_y, z));
  };
  const auto low = [&](int i) { return corner(i, 1.35, 0.82, 0.0); };
  const auto high = [&](int i) { return corner(i, 0.8, 0.66, 0.58); };
  solids.begin_solid();
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    solids.add_face({low(i), low(j), high(j), high(i)}, glass);
    solids.add_edge(low(i), low(j), "car");
    solids.add_edge(high(i), high(j), "car");
    solids.add_edge(low(i), high(i), "car");
  }
  solids.add_face({high(0), high(1), high(2), high(3)}, roof);
}

Look leaves(RandomStream& random) {
  static const std::array<Vector3d, 4> colours{
      Vector3d(0.10, 0.17, 0.06), Vector3d(0.14, 0.20, 0.07), Vector3d(0.08, 0.13, 0.06),
      Vector3d(0.19, 0.22, 0.09)};
  return {Material::kLeaves, colours[random.index(4)] * random.uniform(0.8, 1.3), random.bits()};
}

}  // namespace

void add_ground(Scene& scene, const GroundPatch& patch) {
  const Vector2d along = patch.half_size.x() * patch.along;
  const Vector2d across = patch.half_size.y() * Vector2d(-patch.along.y(), patch.along.x());
  const std::array<Vector2d, 4> c{patch.centre - along - across, patch.centre + along - across,
                                  patch.centre + along + across, patch.centre - along + across};
  for (std::size_t i = 0; i < 4; ++i) {
    scene.edges.push_back({{scene.on_ground(c[i]), scene.on_ground(c[(i + 1) % 4])}, "ground"});
  }
  scene.ground.push_back(patch);
}

void add_car(Scene& scene, const Vector2d& place, const Vector2d& along, RandomStream& random) {
  static const std::array<Vector3d, 7> colours{
      Vector3d(0.75, 0.75, 0.75), Vector3d(0.04, 0.04, 0.045), Vector3d(0.30, 0.31, 0.33),
      Vector3d(0.45, 0.05, 0.05), Vector3d(0.06, 0.12, 0.35),  Vector3d(0.5, 0.5, 0.48),
      Vector3d(0.12, 0.13, 0.14)};
  const Look paint{Material::kPaint, colours[random.index(7)], random.bits()};
  Solids solids(standing_at(scene, place, along));
  const double half_length = random.uniform(1.9, 2.3);
  const Eigen::AlignedBox3d body(Vector3d(-half_length, -0.88, 0.2),
                                 Vector3d(half_length, 0.88, 0.85));
  solids.add_box(body, paint, paint, "car");
  add_cabin(solids, {random.uniform(-0.5, -0.1), 0.0, 0.85}, paint);
  solids.finish(scene, "car");
}

void add_tree(Scene& scene, const Vector2d& place, double radius_m, RandomStream& random) {
  const Look look = leaves(random);
  const double middle_m = radius_m * random.uniform(1.0, 1.3) + 1.0;
  const int n_parts = 25 + static_cast<int>(radius_m * 18.0);
  for (int i = 0; i < n_parts; ++i) {
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    const double out = radius_m * 0.8 * std::sqrt(random.uniform());
    const double up = random.uniform(-0.5, 0.7) * std::sqrt(radius_m * radius_m - out * out);
    const double size = radius_m * random.uniform(0.15, 0.33);
    const Vector3d centre = scene.on_ground(place) +
                            Vector3d(out * std::cos(angle), out * std::sin(angle), middle_m + up);
    Look own = look;
    own.colour *= random.uniform(0.85, 1.15);
    scene.ellipsoids.push_back({centre, size * Vector3d(1.0, 1.0, random.uniform(0.7, 1.0)), own});
  }
}

void add_hedge(Scene& scene, const Vector2d& from, const Vector2d& to, RandomStream& random) {
  constexpr double kStep_m = 0.45;
  const Look look = leaves(random);
  const double height_m = random.uniform(0.9, 1.8);
  const int n_bushes = static_cast<int>((to - from).norm() / kStep_m);
  for (int i = 0; i <= n_bushes; ++i) {
    const double share = (i + 0.5) / (n_bushes + 1);
    const Vector2d shift(random.normal(0.08), random.normal(0.08));
    const Vector3d foot = scene.on_ground((1.0 - share) * from + share * to + shift);
    const Vector3d radii(random.uniform(0.4, 0.6), random.uniform(0.4, 0.6),
                         0.5 * height_m * random.uniform(0.9, 1.12));
    Look own = look;
    own.colour *= random.uniform(0.9, 1.1);
    scene.ellipsoids.push_back({foot + Vector3d(0.0, 0.0, 0.5 * height_m), radii, own});
  }
}

void add_fence(Scene& scene, const Vector2d& from, const Vector2d& to, RandomStream& random) {
  const Vector2d along = (to - from).normalized();
  const bool is_wall = random.chance(0.4);
  const double half_m = is_wall ? 0.12 : 0.04;
  const double height_m = random.uniform(0.9, 1.7);
  const Look look = is_wall ? Look{Material::kBrick, Vector3d(0.48, 0.46, 0.43), random.bits()}
                            : Look{Material::kWood, Vector3d(0.33, 0.24, 0.16), random.bits()};
  // level pieces, stepped where the ground falls
  constexpr double kPiece_m = 6.0;
  const int n_pieces = std::max(1, static_cast<int>(std::lround((to - from).norm() / kPiece_m)));
  const double half_piece_m = 0.5 * (to - from).norm() / n_pieces;
  for (int i = 0; i < n_pieces; ++i) {
    Solids solids(standing_at(scene, from + (2 * i + 1) * half_piece_m * along, along));
    solids.add_box(
        {Vector3d(-half_piece_m, -half_m, -0.5), Vector3d(half_piece_m, half_m, height_m)}, look,
        look, "fence");
    solids.finish(scene, "fence");
  }
}

}  // namespace ridgeline::other
