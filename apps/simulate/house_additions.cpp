// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/house_additions.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::simulate {
namespace {

constexpr double kAnnexFoundationM = 1.0;  // as for the house

/// One wall of the main body with its own axes: a along the wall, d outwards.
struct WallFrame {
  Eigen::Vector2d middle, outwards;
  double half_length_m = 0.0;

  [[nodiscard]] Eigen::Vector2d along() const { return {-outwards.y(), outwards.x()}; }
  [[nodiscard]] Eigen::Vector2d at(double a, double d) const {
    return middle + a * along() + d * outwards;
  }
};

struct Annex {
  double centre_a_m = 0.0;
  double width_m = 0.0, depth_m = 0.0;
  double front_height_m = 0.0;  ///< roof height above the ground at the middle of its front wall
  double slope = 0.0;
  double overhang_m = 0.0;
};

WallFrame random_wall(const HouseShape& shape, const AnnexSite& site, Random& random) {
  static const std::array<Eigen::Vector2d, 4> sides{
      Eigen::Vector2d(0.0, -1.0), Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(-1.0, 0.0),
      Eigen::Vector2d(0.0, 1.0)};
  const Eigen::Vector2d& side =
      sides[static_cast<std::size_t>(random.integer(0, site.back_is_free ? 3 : 2))];
  const Eigen::Vector2d half = 0.5 * Eigen::Vector2d(shape.length_m, shape.width_m);
  return {site.centre_m + side.cwiseProduct(half), side, side.x() != 0.0 ? half.y() : half.x()};
}

Annex random_annex(const WallFrame& wall, Random& random) {
  Annex annex;
  annex.width_m = std::min(random.uniform(2.5, 6.0), 2.0 * wall.half_length_m - 1.0);
  annex.depth_m = random.uniform(2.0, 4.0);
  annex.front_height_m = random.uniform(2.3, 2.9);
  const bool is_flat = random.chance(0.4);
  const double pitch_rad = kRadPerDeg * random.uniform(5.0, 12.0);
  if (!is_flat) annex.slope = std::min(std::tan(pitch_rad), 0.6 / annex.depth_m);
  annex.overhang_m = random.chance(0.3) ? 0.0 : random.uniform(0.1, 0.3);
  const double free_m = wall.half_length_m - 0.5 * annex.width_m - 0.4;
  annex.centre_a_m = random.uniform(-free_m, free_m);
  return annex;
}

RoofPart part_of(const HouseShape& shape,
                 const WallFrame& wall,
                 const Annex& annex,
                 const PlanFunction& ground) {
  constexpr double kInsideM = 0.1;  // its inner end reaches into the house
  const double low_a = annex.centre_a_m - 0.5 * annex.width_m;
  const double high_a = annex.centre_a_m + 0.5 * annex.width_m;
  const auto outline = [&](double overhang_m) -> ConvexPolygon {  // counter-clockwise
    const double front_d = annex.depth_m + overhang_m;
    return {wall.at(low_a - overhang_m, -kInsideM), wall.at(low_a - overhang_m, front_d),
            wall.at(high_a + overhang_m, front_d), wall.at(high_a + overhang_m, -kInsideM)};
  };
  RoofPart part;
  part.walls = outline(0.0);
  part.outline = outline(annex.overhang_m);
  part.is_joint = {false, false, false, true};
  const Eigen::Vector2d front = wall.at(annex.centre_a_m, annex.depth_m);
  const Eigen::Vector2d gradient = -annex.slope * wall.outwards;
  part.tops = {{gradient, ground(front) + annex.front_height_m - gradient.dot(front)}};
  part.base_z_m = shape.floor_z_m - kAnnexFoundationM;
  part.slab_thickness_m = 0.15;
  part.building_id = shape.building_id;
  return part;
}

double underside_m(const RoofPart& part, const Eigen::Vector2d& x) {
  double z = std::numeric_limits<double>::infinity();
  for (const PlanFunction& top : part.tops) z = std::min(z, top(x));
  return z - part.slab_thickness_m;
}

/// Whether an annex stays below the roof of its house, is high enough above the ground and stays
/// within reach.
bool fits(const RoofPart& annex,
          const RoofPart& house,
          const WallFrame& wall,
          const AnnexSite& site) {
  constexpr double kBelowEaveM = 0.15;
  constexpr double kMinHeightM = 1.9;
  const std::vector<PlanFunction> house_sides = half_planes(house.outline);
  for (const Eigen::Vector2d& corner : annex.outline) {
    if (corner.norm() > site.reach_m) return false;
    if (annex.tops[0](corner) - site.ground(corner) < kMinHeightM) return false;
    // it must be below the overhang of the house, both at the wall and at the eave
    const Eigen::Vector2d at_wall =
        corner - (corner - wall.middle).dot(wall.outwards) * wall.outwards;
    PlanInterval below{0.0, 1.0};
    const Segment2 outwards{at_wall, at_wall + wall.outwards};
    for (const PlanFunction& side : house_sides) below = clip(below, outwards, side);
    for (const double d : {0.0, below.empty() ? 0.0 : below.end}) {
      const Eigen::Vector2d x = at_wall + d * wall.outwards;
      if (annex.tops[0](x) > underside_m(house, x) - kBelowEaveM) return false;
    }
  }
  return true;
}

/// A dormer that ends well below the main ridge.
std::optional<Dormer> random_small_dormer(const HouseShape& shape, Random& random) {
  constexpr double kReach = 0.85;  // share of the distance to the ridge
  constexpr double kMinFrontHeightM = 0.6;
  Dormer dormer{.type = random.chance(0.5) ? DormerType::kGabled : DormerType::kShed,
                .width_m = random.uniform(1.2, 2.5),
                .setback_m = random.uniform(0.4, 1.2),
                .front_height_m = random.uniform(0.8, 1.2),
                .pitch_rad = kRadPerDeg * random.uniform(20.0, 40.0)};
  const double slope = std::tan(shape.pitch_rad);
  double room_m = kReach * slope * (0.5 * shape.width_m - dormer.setback_m);
  if (dormer.type == DormerType::kGabled) {
    room_m -= 0.5 * dormer.width_m * std::tan(dormer.pitch_rad);
  } else {
    dormer.pitch_rad = shape.pitch_rad - kRadPerDeg * random.uniform(16.0, 24.0);
    if (dormer.pitch_rad < kRadPerDeg * 3.0) return std::nullopt;
    room_m *= 1.0 - std::tan(dormer.pitch_rad) / slope;
  }
  dormer.front_height_m = std::min(dormer.front_height_m, room_m);
  if (dormer.front_height_m < kMinFrontHeightM) return std::nullopt;
  return dormer;
}

}  // namespace

void add_small_dormers(const HouseShape& shape,
                       double ridge_length_m,
                       Random& random,
                       std::vector<RoofPart>& parts) {
  constexpr double kGapM = 0.8;
  const int wanted = random.integer(1, 3);
  std::optional<Dormer> next = random_small_dormer(shape, random);
  if (!next) return;
  const int count = std::min(wanted, static_cast<int>(ridge_length_m / (next->width_m + kGapM)));
  for (int i = 0; i < count; ++i) {
    next->centre_u_m = ((i + 0.5) / count - 0.5) * ridge_length_m;
    parts.push_back(dormer(shape, *next));
  }
}

void add_annex(const HouseShape& shape,
               const AnnexSite& site,
               Random& random,
               std::vector<RoofPart>& parts) {
  constexpr int kAttempts = 20;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const WallFrame wall = random_wall(shape, site, random);
    const RoofPart annex = part_of(shape, wall, random_annex(wall, random), site.ground);
    if (!fits(annex, parts.front(), wall, site)) continue;
    parts.push_back(annex);
    return;
  }
}

}  // namespace ridgeline::simulate
