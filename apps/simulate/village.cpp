// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/village.h"

#include "apps/simulate/furniture.h"
#include "apps/simulate/garden_wall.h"
#include "apps/simulate/lot.h"
#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/parked_cars.h"
#include "apps/simulate/random.h"
#include "apps/simulate/terrain.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ridgeline::simulate {
namespace {

constexpr double kHalfRowM = kHalfStreetM + kLotSizeM;

/// Separate random streams, so that the content of one lot does not depend on its neighbours.
constexpr double kParkingShare = 0.5;  ///< share of parking lots among the lots without a house

enum VillageStream : std::uint64_t { kTerrainStream, kLotStream, kClutterStream };

void check_share(const char* name, double value) {
  check(value >= 0.0 && value <= 1.0, name, " = ", value, ", must be in [0, 1]");
}

void check_options(const VillageOptions& o) {
  check((o.extent_m.array() >= kMinExtent_m).all() && (o.extent_m.array() <= kMaxExtent_m).all(),
        "extent_m = ", o.extent_m.transpose(), ", must be in [", kMinExtent_m, ", ", kMaxExtent_m,
        "] each");
  static_assert(kMinExtent_m >= 2.0 * kLotSizeM);
  check(o.origin_m.array().round().isApprox(o.origin_m.array(), 0.0),
        "origin_m = ", o.origin_m.transpose(), ", must be integers");
  check_share("aligned_share", o.aligned_share);
  check_share("built_share", o.built_share);
  check_share("fence_share", o.fence_share);
  check(o.terrain_slope_deg >= 0.0 && o.terrain_slope_deg <= 15.0,
        "terrain_slope_deg = ", o.terrain_slope_deg, ", must be in [0, 15]");
  check(o.terrace_step_m >= 0.0 && o.terrace_step_m <= 5.0, "terrace_step_m = ", o.terrace_step_m,
        ", must be in [0, 5]");
  check(o.min_pitch_deg >= 10.0 && o.max_pitch_deg <= 55.0 && o.min_pitch_deg <= o.max_pitch_deg,
        "min_pitch_deg, max_pitch_deg = ", o.min_pitch_deg, ", ", o.max_pitch_deg,
        ", must be ordered and in [10, 55]");
  check_share("annex_share", o.annex_share);
  check_share("dormer_share", o.dormer_share);
  check_share("garden_wall_share", o.garden_wall_share);
  check(o.cars_per_lot >= 0.0 && o.cars_per_lot <= 4.0, "cars_per_lot = ", o.cars_per_lot,
        ", must be in [0, 4]");
  check(o.trees_per_lot >= 0.0 && o.trees_per_lot <= 6.0, "trees_per_lot = ", o.trees_per_lot,
        ", must be in [0, 6]");
}

class VillageBuilder {
 public:
  VillageBuilder(const VillageOptions& options, SyntheticScene& scene)
      : options_(options),
        azimuth_rad_(kRadPerDeg * options.street_azimuth_deg),
        scene_(scene),
        terrain_(azimuth_rad_, scene) {}

  void build() {
    const double reach_m = 0.5 * scene_.extent_m.norm();
    const int rows = static_cast<int>(std::ceil((reach_m - kHalfRowM) / (2.0 * kHalfRowM)));
    const int lots = static_cast<int>(std::ceil(reach_m / kLotSizeM));
    TerrainRow previous;
    for (int r = -rows; r <= rows; ++r) {
      PlanFunction ground = scene_.mean_terrain;
      ground.offset += options_.terrace_step_m * static_cast<double>(r);
      const TerrainRow row = terrain_.add_row(2.0 * kHalfRowM * r, kHalfRowM, ground);
      if (r > -rows && options_.terrace_step_m > 0.0) {
        const double wall_v_m = row.street_v_m - kHalfRowM;
        terrain_.add_retaining_wall(previous, row, wall_v_m, scene_.extent_m.norm());
        if (options_.with_feet) add_retaining_wall_lines(previous, row, wall_v_m, lots);
      }
      for (int i = -lots; i < lots; ++i) add_lot_pair(row, r, i);
      previous = row;
    }
  }

 private:
  void add_lot_pair(const TerrainRow& row, int r, int i) {
    const double begin_u = kLotSizeM * i;
    terrain_.add_street(row, begin_u, begin_u + kLotSizeM);
    for (const int side : {-1, 1}) {
      const double low_v = side > 0 ? row.street_v_m + kHalfStreetM : row.street_v_m - kHalfRowM;
      const auto stream = [&](VillageStream kind) {
        return Random({options_.seed, kind, static_cast<std::uint64_t>(r),
                       static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(side)});
      };
      Random random = stream(kLotStream);
      Random clutter = stream(kClutterStream);
      add_lot(row, {begin_u, low_v}, random, clutter);
    }
  }

  /// Adds the foot and the upper edge, lot by lot.
  void add_retaining_wall_lines(const TerrainRow& low,
                                const TerrainRow& high,
                                double v_m,
                                int lots) {
    for (int i = -lots; i < lots; ++i) {
      const Eigen::Vector2d begin(kLotSizeM * i, v_m);
      const Eigen::Vector2d end(kLotSizeM * (i + 1), v_m);
      terrain_.add_line(low, begin, end, LineKind::kFoot);
      terrain_.add_line(high, begin, end, LineKind::kGround);
    }
  }

  void add_lot(const TerrainRow& row,
               const Eigen::Vector2d& low_uv,
               Random& random,
               Random& clutter) {
    const Eigen::Vector2d high_uv = low_uv + Eigen::Vector2d::Constant(kLotSizeM);
    const Eigen::Vector2d centre = terrain_.local(0.5 * (low_uv + high_uv));
    const bool inside = (centre.array() >= kHouseRadiusM).all() &&
                        (centre.array() <= scene_.extent_m.array() - kHouseRadiusM).all();
    const std::size_t first_building = scene_.buildings.size();
    const bool built = random.chance(options_.built_share);
    if (!built && random.chance(kParkingShare)) {
      terrain_.add_parking(row, low_uv, high_uv);
      add_cars(row, low_uv, random);
      return;
    }
    terrain_.add_tile(row, low_uv, high_uv, Material::kGround);
    if (built && inside) add_random_house(row, centre, random, clutter);
    const std::vector<Eigen::Vector2d> trees = add_trees(row, low_uv, first_building, random);
    if (random.chance(options_.fence_share)) {
      add_fence(row, low_uv);
    } else if (clutter.chance(options_.garden_wall_share)) {
      add_garden_wall(terrain_, row, low_uv, options_.with_feet, clutter, scene_);
    }
    const auto is_clear = [&](const Eigen::Vector2d& x, double radius_m) {
      return is_free(x, radius_m, first_building);
    };
    park_cars({terrain_, row, low_uv, azimuth_rad_, is_clear}, options_.cars_per_lot,
              options_.with_objects, trees, clutter, scene_);
  }

  void add_random_house(const TerrainRow& row,
                        const Eigen::Vector2d& centre,
                        Random& random,
                        Random& clutter) {
    const std::vector<RoofType>& types = options_.roof_types;
    const RoofType type = types.empty()
                              ? static_cast<RoofType>(random.integer(0, kNumRoofTypes - 1))
                              : types[static_cast<std::size_t>(
                                    random.integer(0, static_cast<int>(types.size()) - 1))];
    Site site{.centre_m = centre};
    site.floor_z_m = row.ground(centre) - row.ground.gradient.norm() * kHouseRadiusM;
    site.azimuth_rad = house_azimuth_rad(random);
    site.ground = {row.ground, row.plane_id};
    add_house(options_, type, site, random, clutter, scene_);
  }

  /// The azimuth of a house: parallel to x, or along or across the street with some variation.
  double house_azimuth_rad(Random& random) const {
    if (random.chance(options_.aligned_share)) return random.chance(0.5) ? 0.0 : std::numbers::pi;
    const double jitter = kRadPerDeg * random.uniform(-8.0, 8.0);
    const double quarter = 0.5 * std::numbers::pi * random.integer(0, 3);
    return azimuth_rad_ + quarter + jitter;
  }

  /// Returns the positions of the trunks.
  std::vector<Eigen::Vector2d> add_trees(const TerrainRow& row,
                                         const Eigen::Vector2d& low_uv,
                                         std::size_t first_building,
                                         Random& random) {
    std::vector<Eigen::Vector2d> trunks;
    const double expected = options_.trees_per_lot;
    const int count = static_cast<int>(std::floor(expected + random.uniform()));
    for (int i = 0; i < count; ++i) {
      const bool bush = random.chance(0.3);
      const double radius = bush ? random.uniform(0.6, 1.2) : random.uniform(1.6, 3.2);
      const double height = bush ? 1.4 * radius : random.uniform(2.2, 3.6) * radius;
      for (int attempt = 0; attempt < 20; ++attempt) {
        const Eigen::Vector2d uv =
            low_uv + Eigen::Vector2d{random.uniform(radius, kLotSizeM - radius),
                                     random.uniform(radius, kLotSizeM - radius)};
        const Eigen::Vector2d x = terrain_.local(uv);
        if (!is_free(x, radius, first_building)) continue;
        add_tree({x.x(), x.y(), row.ground(x)}, radius, height, random, scene_.mesh);
        trunks.push_back(x);
        break;
      }
    }
    return trunks;
  }

  /// Whether a tree may stand at `x`. Its crown may overhang a roof by up to a metre; its trunk
  /// must be clear of the walls.
  [[nodiscard]] bool is_free(const Eigen::Vector2d& x,
                             double radius_m,
                             std::size_t first_building) const {
    constexpr double kOverRoofM = 1.0;
    const double distance_m = std::max(0.5, radius_m - kOverRoofM);
    if ((x.array() < radius_m).any() || (x.array() > scene_.extent_m.array() - radius_m).any()) {
      return false;
    }
    for (std::size_t b = first_building; b < scene_.buildings.size(); ++b) {
      for (const ConvexPolygon& outline : scene_.buildings[b].roof_footprint) {
        const std::vector<PlanFunction> sides = half_planes(outline);
        const bool outside = std::any_of(sides.begin(), sides.end(), [&](const PlanFunction& side) {
          return side(x) <= -distance_m;
        });
        if (!outside) return false;
      }
    }
    return true;
  }

  void add_cars(const TerrainRow& row, const Eigen::Vector2d& low_uv, Random& random) {
    constexpr double kBayM = 2.5;
    for (int bay = 0; bay < 8; ++bay) {
      if (!random.chance(0.5)) continue;
      const Eigen::Vector2d x = terrain_.local(low_uv + Eigen::Vector2d(kBayM * (bay + 0.5), 2.5));
      if ((x.array() < 3.0).any() || (x.array() > scene_.extent_m.array() - 3.0).any()) continue;
      const Car car{.foot = {x.x(), x.y(), row.ground(x)},
                    .azimuth_rad = azimuth_rad_ + 0.5 * std::numbers::pi};
      add_parked_car(car, options_.with_objects, scene_);
    }
  }

  void add_fence(const TerrainRow& row, const Eigen::Vector2d& low_uv) {
    constexpr double kThicknessM = 0.1;
    constexpr double kHeightM = 1.2;
    constexpr double kPanelM = 2.0;
    constexpr int kPanels = static_cast<int>(kLotSizeM / kPanelM);
    for (int i = 0; i < kPanels; ++i) {  // panels follow the slope in steps
      const double v = kPanelM * i;
      ConvexPolygon panel = rectangle(low_uv + Eigen::Vector2d(0.0, v),
                                      low_uv + Eigen::Vector2d(kThicknessM, v + kPanelM));
      bool inside = true;
      for (Eigen::Vector2d& x : panel) {
        x = terrain_.local(x);
        inside = inside && (x.array() >= 0.0).all() && (x.array() <= scene_.extent_m.array()).all();
      }
      if (!inside) continue;
      const double ground_z = row.ground(panel.front());
      add_prism(panel, ground_z - 0.5, ground_z + kHeightM, {kNone, kNone, Material::kWood},
                scene_.mesh);
    }
  }

  const VillageOptions& options_;
  double azimuth_rad_;
  SyntheticScene& scene_;
  Terrain terrain_;
};

/// Adds the upper edges of all chimneys.
void add_chimney_lines(SyntheticScene& scene) {
  for (const ScenePlane& plane : scene.planes) {
    if (plane.kind != PlaneKind::kChimney) continue;
    for (std::size_t i = 0; i < plane.outline.size(); ++i) {
      const Eigen::Vector3d& end = plane.outline[(i + 1) % plane.outline.size()];
      scene.lines.push_back({.segment = {plane.outline[i], end},
                             .kind = LineKind::kObject,
                             .plane_ids = {},
                             .building_id = plane.building_id});
    }
  }
}

}  // namespace

SyntheticScene make_village(const VillageOptions& options) {
  check_options(options);
  SyntheticScene scene;
  scene.frame.origin_m = options.origin_m;
  scene.crs.definition = options.crs;
  scene.extent_m = options.extent_m;

  Random random({options.seed, kTerrainStream});
  const double slope = std::tan(kRadPerDeg * options.terrain_slope_deg);
  const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
  scene.mean_terrain.gradient = slope * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
  scene.mean_terrain.offset = -scene.mean_terrain.gradient.dot(0.5 * scene.extent_m);

  VillageBuilder(options, scene).build();
  if (options.with_objects) add_chimney_lines(scene);
  return scene;
}

void set_clutter(VillageOptions& options) {
  options.annex_share = 0.5;
  options.dormer_share = 0.6;
  options.cars_per_lot = 1.5;
  options.garden_wall_share = 0.5;
  options.with_feet = true;
  options.with_objects = true;
}

}  // namespace ridgeline::simulate
