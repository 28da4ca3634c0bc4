// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/parked_cars.h"

#include "apps/simulate/lot.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace ridgeline::simulate {
namespace {

Car random_car(Random& random) {
  Car car;
  car.half_length_m = random.uniform(1.9, 2.4);
  car.half_width_m = random.uniform(0.82, 0.95);
  car.bonnet_m = random.uniform(0.8, 1.0);
  car.cabin_half_length_m = random.uniform(1.0, 1.4);
  car.cabin_half_width_m = car.half_width_m - 0.12;
  car.roof_m = random.uniform(1.4, 1.75);
  return car;
}

/// A place on the street, 0.3 m from the border of the lot.
Eigen::Vector2d kerb_place(const CarSite& site, double u_in_lot_m, const Car& car) {
  constexpr double kGapM = 0.3;
  const double side = site.low_uv.y() > site.row.street_v_m ? 1.0 : -1.0;
  return {site.low_uv.x() + u_in_lot_m,
          site.row.street_v_m + side * (kHalfStreetM - kGapM - car.half_width_m)};
}

/// A place for a car, in local coordinates, if one is found.
std::optional<Eigen::Vector2d> free_place(const CarSite& site,
                                          const Car& car,
                                          bool at_kerb,
                                          const std::vector<Eigen::Vector2d>& taken,
                                          Random& random) {
  constexpr int kAttempts = 20;
  constexpr double kCarM = 2.7;    // half its length plus some space
  constexpr double kClearM = 3.5;  // from the house's roof, minus the overhang allowed for trees
  constexpr double kApartM = 5.0;  // between the centres of two cars
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Eigen::Vector2d in_lot{random.uniform(kCarM, kLotSizeM - kCarM),
                                 random.uniform(kCarM, kLotSizeM - kCarM)};
    const Eigen::Vector2d uv =
        at_kerb ? kerb_place(site, in_lot.x(), car) : Eigen::Vector2d(site.low_uv + in_lot);
    const Eigen::Vector2d x = site.terrain.local(uv);
    const bool apart = std::all_of(taken.begin(), taken.end(), [&](const Eigen::Vector2d& y) {
      return (x - y).norm() >= kApartM;
    });
    if (apart && site.is_free(x, kClearM)) return x;
  }
  return std::nullopt;
}

}  // namespace

void add_parked_car(const Car& car, bool with_lines, SyntheticScene& scene) {
  add_car(car, scene.mesh);
  if (!with_lines) return;
  for (const Segment3& edge : edges_of(car)) {
    scene.lines.push_back(
        {.segment = edge, .kind = LineKind::kObject, .plane_ids = {}, .building_id = kNone});
  }
}

void park_cars(const CarSite& site,
               double mean_count,
               bool with_lines,
               std::vector<Eigen::Vector2d> taken,
               Random& random,
               SyntheticScene& scene) {
  const int count = static_cast<int>(std::floor(mean_count + random.uniform()));
  for (int i = 0; i < count; ++i) {
    const bool at_kerb = random.chance(0.5);
    Car car = random_car(random);
    const double turn = at_kerb ? 0.0 : 0.5 * std::numbers::pi * random.integer(0, 1);
    car.azimuth_rad = site.street_azimuth_rad + turn + kRadPerDeg * random.uniform(-4.0, 4.0);
    const auto x = free_place(site, car, at_kerb, taken, random);
    if (!x) continue;
    car.foot = {x->x(), x->y(), site.row.ground(*x)};
    add_parked_car(car, with_lines, scene);
    taken.push_back(*x);
  }
}

}  // namespace ridgeline::simulate
