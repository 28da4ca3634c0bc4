// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/house_additions.h"

#include "tests/other_scenes/roof_details.h"

#include <algorithm>

namespace ridgeline::other {
namespace {

using Eigen::Vector2d;

/// A wall of the house in plan: the middle of its foot, its direction outwards, and half its
/// length.
struct WallPlace {
  Vector2d middle, outwards;
  double half_length_m = 0.0;
};

WallPlace random_wall(const HouseBody& body, bool has_room, RandomStream& random) {
  const double half_x = 0.5 * body.wing.length_m - body.wing.overhang_m;
  const double half_y = 0.5 * body.wing.width_m - body.wing.overhang_m;
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  if (!has_room) return {{side * half_x, 0.0}, {side, 0.0}, half_y};
  const double free_side = body.has_cross_wing ? body.detailed_side : side;
  return {{0.0, free_side * half_y}, {0.0, free_side}, half_x};
}

Look annex_roof(RandomStream& random) {
  const double grey = random.uniform(0.16, 0.42);
  const Material material = random.chance(0.5) ? Material::kBitumen : Material::kMetal;
  return {material, grey * Eigen::Vector3d(1.0, 1.0, 1.03), random.bits()};
}

void add_annex(Solids& solids, const HouseBody& body, const WallPlace& wall, RandomStream& random) {
  constexpr double kInside_m = 0.3;     // of its roof, within the house
  constexpr double kBelowEave_m = 0.2;  // at least, of its upper end
  const double depth_m = random.uniform(2.0, 3.6);
  const bool is_flat = random.chance(0.4);
  Wing annex;
  annex.length_m = random.uniform(3.0, std::min(6.5, 2.0 * wall.half_length_m - 0.8));
  annex.overhang_m = is_flat ? 0.0 : random.uniform(0.1, 0.25);
  annex.eave_m = random.uniform(2.1, 2.5);
  annex.ridge_m = annex.eave_m + (depth_m + kInside_m) * random.uniform(0.08, 0.22);
  annex.ridge_m = std::min(annex.ridge_m, body.wing.eave_m - kBelowEave_m);
  annex.eave_m = std::min(annex.eave_m, annex.ridge_m - 0.15);
  annex.width_m = depth_m + annex.overhang_m + kInside_m;
  annex.roof = annex_roof(random);
  annex.walls = body.wing.walls;
  const double free_m = wall.half_length_m - 0.5 * annex.length_m;
  const Vector2d along(-wall.outwards.y(), wall.outwards.x());
  const Vector2d middle = wall.middle + random.uniform(-free_m, free_m) * along +
                          0.5 * (depth_m + annex.overhang_m - kInside_m) * wall.outwards;
  // its y axis points into the house
  const double turn = std::atan2(-wall.outwards.y(), -wall.outwards.x()) - 0.5 * M_PI;
  annex.house_from_wing = Eigen::Translation3d(middle.x(), middle.y(), 0.0) *
                          Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
  if (is_flat) {
    annex.ridge_m = annex.eave_m;
    add_flat(solids, annex, random.uniform(0.1, 0.2));
  } else {
    add_shed(solids, annex);
  }
}

void add_small_dormers(Solids& solids, const HouseBody& body, RandomStream& random) {
  const Dormer dormer{.width_m = random.uniform(1.3, 2.4),
                      .front_height_m = random.uniform(0.8, 1.1),
                      .overhang_m = 0.12};
  const double place_m = random.uniform(0.12, 0.25) * body.wing.length_m;
  for (const double end : {-1.0, 1.0}) {
    if (random.chance(0.75)) {
      add_dormer(solids, body.wing, -body.detailed_side, end * place_m, dormer);
    }
  }
}

}  // namespace

void add_additions(Solids& solids, const HouseBody& body, bool has_room, RandomStream& random) {
  if (random.chance(0.7)) add_annex(solids, body, random_wall(body, has_room, random), random);
  if (body.has_ridge && !body.has_cross_wing && random.chance(0.7)) {
    add_small_dormers(solids, body, random);
  }
}

}  // namespace ridgeline::other
