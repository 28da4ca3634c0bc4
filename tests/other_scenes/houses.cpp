// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/houses.h"

#include "tests/other_scenes/house_additions.h"
#include "tests/other_scenes/roof_details.h"
#include "tests/other_scenes/roofs.h"

#include <array>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

template <std::size_t kCount>
Vector3d shade_of(const std::array<Vector3d, kCount>& colours, RandomStream& random) {
  return colours[random.index(static_cast<int>(kCount))] * random.uniform(0.85, 1.15);
}

Look tile_roof(RandomStream& random) {
  static const std::array<Vector3d, 6> colours{
      Vector3d(0.40, 0.16, 0.10), Vector3d(0.46, 0.23, 0.14), Vector3d(0.27, 0.15, 0.11),
      Vector3d(0.12, 0.12, 0.13), Vector3d(0.33, 0.20, 0.15), Vector3d(0.22, 0.23, 0.24)};
  return {Material::kTiles, shade_of(colours, random), random.bits()};
}

Look metal_roof(RandomStream& random) {
  static const std::array<Vector3d, 3> colours{
      Vector3d(0.42, 0.44, 0.46), Vector3d(0.30, 0.42, 0.36), Vector3d(0.22, 0.23, 0.26)};
  return {Material::kMetal, shade_of(colours, random), random.bits()};
}

Look felt(RandomStream& random) {
  static const std::array<Vector3d, 3> colours{
      Vector3d(0.30, 0.29, 0.28), Vector3d(0.17, 0.17, 0.18), Vector3d(0.40, 0.38, 0.35)};
  return {Material::kBitumen, shade_of(colours, random), random.bits()};
}

Look wall(RandomStream& random) {
  static const std::array<Vector3d, 6> colours{
      Vector3d(0.66, 0.65, 0.62), Vector3d(0.62, 0.55, 0.40), Vector3d(0.58, 0.44, 0.35),
      Vector3d(0.45, 0.48, 0.50), Vector3d(0.70, 0.68, 0.58), Vector3d(0.35, 0.20, 0.16)};
  return {Material::kPlaster, shade_of(colours, random), random.bits()};
}

Wing main_wing(RandomStream& random) {
  Wing wing;
  wing.length_m = random.uniform(10.5, 15.0);
  wing.width_m = random.uniform(8.0, 10.5);
  wing.overhang_m = random.uniform(0.25, 0.6);
  wing.eave_m = random.chance(0.5) ? random.uniform(2.7, 3.6) : random.uniform(5.0, 6.2);
  wing.ridge_m = wing.eave_m + 0.5 * wing.width_m * random.uniform(0.45, 1.0);
  wing.roof = random.chance(0.85) ? tile_roof(random) : metal_roof(random);
  wing.walls = wall(random);
  return wing;
}

/// A wing across the first one, out to y > 0 or y < 0; where their ridges differ, the roofs meet in
/// two valleys.
Wing cross_wing(const Wing& main, double side, RandomStream& random) {
  Wing wing = main;
  wing.hipped = {0.0, random.chance(0.3) ? 1.0 : 0.0};
  wing.width_m = random.uniform(0.6, 0.8) * main.width_m;
  const double out_m = random.uniform(3.0, 4.5);
  wing.length_m = 0.5 * main.width_m + out_m;
  wing.ridge_m = wing.eave_m + 0.5 * wing.width_m * main.slope();
  const double room_m = 0.5 * (main.length_m - wing.width_m);
  const double along_m = random.chance(0.5) ? room_m - 0.4 : -room_m + 0.4;
  wing.house_from_wing = Eigen::Translation3d(along_m, side * 0.5 * wing.length_m, 0.0) *
                         Eigen::AngleAxisd(side * 0.5 * M_PI, Vector3d::UnitZ());
  return wing;
}

void add_details(Solids& solids, const Wing& wing, double free_side, RandomStream& random) {
  if (random.chance(0.75)) add_chimney(solids, wing, random);
  const double place = random.uniform(0.1, 0.25) * wing.length_m;
  if (random.chance(0.4)) {
    add_dormer(solids, wing, free_side, -place);
    if (random.chance(0.6)) add_dormer(solids, wing, free_side, place);
  } else if (random.chance(0.3)) {
    add_panels(solids, wing, free_side, random.bits());
  } else {
    for (int i = random.index(4); i > 0; --i) {
      const double along_m = (i - 2) * 2.4 + random.uniform(-0.4, 0.4);
      add_roof_window(solids, wing, free_side, along_m, random.uniform(1.0, 2.2));
    }
  }
}

HouseBody add_ridged(Solids& solids, bool has_room, RandomStream& random) {
  Wing wing = main_wing(random);
  const int type = random.index(has_room ? 5 : 3);
  if (type == 1) wing.hipped = {1.0, 1.0};
  if (type == 2) {
    const double share = random.uniform(0.3, 0.45);
    wing.hipped = {share, share};
  }
  add_wing(solids, wing);
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  if (type >= 3) add_wing(solids, cross_wing(wing, side, random));
  add_details(solids, wing, -side, random);
  return {wing, -side, type >= 3, true};
}

HouseBody add_flat_house(Solids& solids, RandomStream& random) {
  Wing wing = main_wing(random);
  wing.overhang_m = 0.0;
  wing.ridge_m = random.chance(0.5) ? 3.2 : 6.1;
  wing.roof = felt(random);
  add_flat(solids, wing, random.uniform(0.2, 0.5));
  if (random.chance(0.6)) {
    const double x = random.uniform(-3.0, 3.0);
    add_flat(solids,
             {.house_from_wing = Eigen::Isometry3d(Eigen::Translation3d(x, 0.5, 0.0)),
              .length_m = 3.4,
              .width_m = 2.8,
              .overhang_m = 0.0,
              .eave_m = 0.0,
              .ridge_m = wing.ridge_m + 1.4,
              .hipped = {0.0, 0.0},
              .roof = felt(random),
              .walls = wing.walls},
             0.15);
  }
  wing.eave_m = wing.ridge_m;
  return {wing, 1.0, false, false};
}

HouseBody add_shed_house(Solids& solids, RandomStream& random) {
  Wing wing = main_wing(random);
  wing.roof = random.chance(0.5) ? metal_roof(random) : tile_roof(random);
  wing.ridge_m = wing.eave_m + wing.width_m * random.uniform(0.12, 0.28);
  add_shed(solids, wing);
  return {wing, 1.0, false, false};
}

HouseBody add_body(Solids& solids, bool has_room, RandomStream& random) {
  const double type = random.uniform();
  if (type < 0.74) return add_ridged(solids, has_room, random);
  if (type < 0.88) return add_flat_house(solids, random);
  return add_shed_house(solids, random);
}

}  // namespace

void add_house(Scene& scene,
               const Eigen::Vector2d& place,
               const Eigen::Vector2d& along,
               bool has_room,
               RandomStream& random,
               RandomStream* clutter) {
  Solids solids(standing_at(scene, place, along));
  const HouseBody body = add_body(solids, has_room, random);
  if (clutter != nullptr) add_additions(solids, body, has_room, *clutter);
  solids.finish(scene, "wall");
}

void add_garage(Scene& scene,
                const Eigen::Vector2d& place,
                const Eigen::Vector2d& along,
                RandomStream& random) {
  Solids solids(standing_at(scene, place, along));
  Wing wing;
  wing.length_m = random.uniform(5.8, 7.0);
  wing.width_m = random.uniform(3.0, 3.8);
  wing.overhang_m = 0.2;
  wing.eave_m = 2.4;
  wing.walls = wall(random);
  if (random.chance(0.65)) {
    wing.overhang_m = 0.0;
    wing.ridge_m = 2.6;
    wing.roof = felt(random);
    add_flat(solids, wing, 0.12);
  } else {
    wing.ridge_m = wing.eave_m + random.uniform(1.0, 1.6);
    wing.roof = tile_roof(random);
    add_wing(solids, wing);
  }
  solids.finish(scene, "wall");
}

}  // namespace ridgeline::other
