// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/settlement.h"

#include "tests/other_scenes/houses.h"
#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/surroundings.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace ridgeline::other {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStreetHalf_m = 3.0, kPavementHalf_m = 0.85;
constexpr double kKerb_m = kStreetHalf_m + 2.0 * kPavementHalf_m;  ///< where gardens begin
constexpr double kParcelDepth_m = 25.0;
constexpr double kReach_m = 70.0;  ///< of streets, beyond the patch

/// A street with its own axes: x along it, y across from its middle.
struct Street {
  Vector2d origin, along;
  [[nodiscard]] Vector2d across() const { return {-along.y(), along.x()}; }
  [[nodiscard]] Vector2d at(double x, double y) const { return origin + x * along + y * across(); }
};

Vector2d turned(const Vector2d& v, double angle_rad) { return Eigen::Rotation2Dd(angle_rad) * v; }

void add_plain(Scene& scene, RandomStream& random) {
  constexpr double kHalf_m = 150.0;
  std::vector<Vector3d> corners;
  for (const Vector2d& c :
       {Vector2d(-1.0, -1.0), Vector2d(1.0, -1.0), Vector2d(1.0, 1.0), Vector2d(-1.0, 1.0)}) {
    corners.push_back(scene.on_ground(kHalf_m * c));
  }
  scene.faces.push_back({corners, {Material::kGround, Vector3d::Zero(), 0}});
  scene.ground.push_back({Vector2d::Zero(), turned(Vector2d::UnitX(), random.uniform(0.0, 3.0)),
                          Vector2d(300.0, 300.0),
                          random.chance(0.5) ? Paving::kField : Paving::kLawn,
                          Vector3d(0.20, 0.22, 0.11), random.bits()});
}

void add_markings(Scene& scene, const Street& street, RandomStream& random) {
  constexpr double kDash_m = 3.0, kPitch_m = 8.0, kHalfWidth_m = 0.07;
  constexpr int kDashes = 18;  // to the end of the street
  for (int i = 0; i < kDashes; ++i) {
    const double x = -kReach_m + i * kPitch_m;
    add_ground(scene, {street.at(x, 0.0), street.along, Vector2d(0.5 * kDash_m, kHalfWidth_m),
                       Paving::kMarking, Vector3d(0.62, 0.62, 0.6), random.bits()});
  }
  // a crossing for pedestrians
  const double crossing_x = random.uniform(-25.0, 25.0);
  for (int i = 0; i < 6; ++i) {
    const double y = i - kStreetHalf_m + 0.6;
    add_ground(scene, {street.at(crossing_x, y), street.along, Vector2d(1.5, 0.25),
                       Paving::kMarking, Vector3d(0.65, 0.65, 0.63), random.bits()});
  }
}

void add_street(Scene& scene, const Street& street, RandomStream& random) {
  const double grey = random.uniform(0.13, 0.24);
  add_ground(scene, {street.origin, street.along, Vector2d(kReach_m, kStreetHalf_m),
                     Paving::kAsphalt, Vector3d(grey, grey, 1.03 * grey), random.bits()});
  for (const double side : {-1.0, 1.0}) {
    const double y = side * (kStreetHalf_m + kPavementHalf_m);
    add_ground(scene, {street.at(0.0, y), street.along, Vector2d(kReach_m, kPavementHalf_m),
                       Paving::kSlabs, Vector3d(0.36, 0.35, 0.33), random.bits()});
  }
  add_markings(scene, street, random);
  double x = -kReach_m;
  while (x < kReach_m) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const Vector2d heading = turned(street.along, random.normal(0.02));
    add_car(scene, street.at(x, side * (kStreetHalf_m - 1.0)), heading, random);
    x += random.uniform(6.0, 30.0);
  }
}

/// A parcel beside a street: x along it from its middle, y away from the street, both metres.
struct Parcel {
  Street street;
  double middle_m, width_m, side;
  [[nodiscard]] Vector2d at(double x, double y) const {
    return street.at(middle_m + x, side * (kKerb_m + y));
  }
};

void add_garden(Scene& scene, const Parcel& parcel, RandomStream& random) {
  const Vector3d green = Vector3d(0.15, 0.22, 0.08) * random.uniform(0.8, 1.35);
  add_ground(scene,
             {parcel.at(0.0, 0.5 * kParcelDepth_m), parcel.street.along,
              0.5 * Vector2d(parcel.width_m, kParcelDepth_m), Paving::kLawn, green, random.bits()});
}

void add_border(Scene& scene, const Vector2d& from, const Vector2d& to, RandomStream& random) {
  const double type = random.uniform();
  if (type < 0.3) add_hedge(scene, from, to, random);
  if (type >= 0.3 && type < 0.6) add_fence(scene, from, to, random);
}

GroundPatch paved(const Parcel& parcel,
                  const Vector2d& middle,
                  const Vector2d& half,
                  RandomStream& random) {
  const Paving paving =
      std::array{Paving::kSlabs, Paving::kGravel, Paving::kAsphalt}[random.index(3)];
  const double grey = random.uniform(0.2, 0.45);
  return {parcel.at(middle.x(), middle.y()),        parcel.street.along, half, paving,
          Vector3d(1.05 * grey, grey, 0.93 * grey), random.bits()};
}

/// A drive along one border of the parcel with a garage at its end, often a car on it.
void add_drive(Scene& scene, const Parcel& parcel, double border_side, RandomStream& random) {
  const double x = border_side * (0.5 * parcel.width_m - 2.2);
  const double length_m = random.uniform(6.5, 10.0);
  add_ground(scene, paved(parcel, {x, 0.5 * length_m}, {1.6, 0.5 * length_m}, random));
  const Vector2d outward = parcel.side * parcel.street.across();
  if (random.chance(0.8)) add_garage(scene, parcel.at(x, length_m + 3.4), outward, random);
  if (random.chance(0.5)) {
    add_car(scene, parcel.at(x, random.uniform(2.8, 4.0)), turned(outward, random.normal(0.03)),
            random);
  }
}

void add_parcel_house(Scene& scene,
                      const Parcel& parcel,
                      double drive_side,
                      RandomStream& random,
                      RandomStream* clutter) {
  const bool gable_to_street = parcel.width_m < 19.5 || random.chance(0.15);
  const double turn = random.normal(0.015) + (gable_to_street ? 0.5 * M_PI : 0.0);
  const Vector2d place = parcel.at(-1.9 * drive_side, gable_to_street ? 12.5 : 10.5);
  add_house(scene, place, turned(parcel.street.along, turn), !gable_to_street, random, clutter);
  const double terrace_y = random.uniform(19.5, 20.5);
  if (random.chance(0.7)) {
    add_ground(scene, paved(parcel, {-2.0 * drive_side, terrace_y}, {random.uniform(1.5, 3.0), 1.6},
                            random));
  }
}

void add_trees(Scene& scene, const Parcel& parcel, RandomStream& random) {
  for (int i = random.index(5); i > 0; --i) {
    const double x = random.uniform(-0.42, 0.42) * parcel.width_m;
    const double y = random.chance(0.8) ? random.uniform(20.5, 24.0) : random.uniform(1.2, 2.2);
    add_tree(scene, parcel.at(x, y), y < 5.0 ? random.uniform(0.7, 1.3) : random.uniform(1.2, 2.8),
             random);
  }
}

void add_parcel(Scene& scene, const Parcel& parcel, RandomStream& random, RandomStream* clutter) {
  add_garden(scene, parcel, random);
  const double drive_side = random.chance(0.5) ? 1.0 : -1.0;
  add_drive(scene, parcel, drive_side, random);
  add_parcel_house(scene, parcel, drive_side, random, clutter);
  const double half = 0.5 * parcel.width_m;
  add_border(scene, parcel.at(half, 0.4), parcel.at(half, kParcelDepth_m - 0.4), random);
  add_border(scene, parcel.at(-half + 0.6, kParcelDepth_m), parcel.at(half - 0.6, kParcelDepth_m),
             random);
  add_border(scene, parcel.at(-drive_side * (half - 0.4), 0.3),
             parcel.at(drive_side * (half - 4.4), 0.3), random);
  add_trees(scene, parcel, random);
}

void add_parcels(
    Scene& scene, const Street& street, double side, RandomStream& random, RandomStream* clutter) {
  double x = -kReach_m + random.uniform(0.0, 8.0);
  while (x < kReach_m) {
    const double width_m = random.uniform(17.0, 23.0);
    const Parcel parcel{street, x + 0.5 * width_m, width_m, side};
    x += width_m;
    const Vector2d middle = parcel.at(0.0, 0.5 * kParcelDepth_m);
    if (middle.cwiseAbs().maxCoeff() < scene.half_extent_m + 16.0)
      add_parcel(scene, parcel, random, clutter);
  }
}

/// Light of a summer forenoon or afternoon in the middle of Europe.
Vector3d random_sun(RandomStream& random) {
  const double elevation = random.uniform(38.0, 56.0) * M_PI / 180.0;
  const double azimuth = random.uniform(115.0, 245.0) * M_PI / 180.0;  // clockwise from north
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
          std::sin(elevation)};
}

double street_azimuth_rad(std::uint64_t seed, RandomStream& random) {
  constexpr double kNear_deg = 4.0;
  double angle_deg = random.uniform(0.0, 180.0);
  if (seed % 2 == 0) {
    angle_deg = (random.chance(0.6) ? 0.0 : 90.0) + random.uniform(-kNear_deg, kNear_deg);
  }
  return angle_deg * M_PI / 180.0;
}

Vector2d steep_slope(RandomStream& random) {
  const double slope = random.uniform(0.03, 0.08);
  return turned({slope, 0.0}, random.uniform(0.0, 2.0 * M_PI));
}

}  // namespace

Scene make_settlement(std::uint64_t seed, bool is_hard) {
  RandomStream random(seed);
  RandomStream own_clutter(seed + 3000U);
  RandomStream* const clutter = is_hard ? &own_clutter : nullptr;
  Scene scene;
  scene.half_extent_m = 37.0;
  scene.ground_slope = {random.normal(0.012), random.normal(0.012)};
  if (is_hard) scene.ground_slope = steep_slope(own_clutter);
  scene.to_sun = random_sun(random);
  add_plain(scene, random);
  const Vector2d along = turned(Vector2d::UnitX(), street_azimuth_rad(seed, random));
  const Vector2d across(-along.y(), along.x());
  const double shift_m = random.uniform(-15.0, 15.0);
  constexpr double kPitch_m = 2.0 * (kKerb_m + kParcelDepth_m) + 1.0;
  for (const int i : {-1, 0, 1}) {
    const Street street{(shift_m + i * kPitch_m) * across, along};
    add_street(scene, street, random);
    for (const double side : {-1.0, 1.0}) add_parcels(scene, street, side, random, clutter);
  }
  return scene;
}

}  // namespace ridgeline::other
