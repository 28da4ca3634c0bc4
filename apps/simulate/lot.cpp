// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/lot.h"

#include "apps/simulate/house_additions.h"
#include "apps/simulate/houses.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace ridgeline::simulate {
namespace {

HouseShape random_shape(const VillageOptions& options, const Site& site, Random& random) {
  HouseShape shape;
  shape.length_m = random.uniform(9.5, 13.0);
  shape.width_m = random.uniform(7.5, 9.5);
  shape.pitch_rad = kRadPerDeg * random.uniform(options.min_pitch_deg, options.max_pitch_deg);
  shape.eave_overhang_m = random.uniform(0.2, 0.6);
  shape.verge_overhang_m = random.uniform(0.2, 0.4);
  shape.slab_thickness_m = random.uniform(0.2, 0.3);
  shape.floor_z_m = site.floor_z_m;
  shape.wall_height_m = random.uniform(3.0, 6.5);
  return shape;
}

Dormer random_dormer(const HouseShape& shape, DormerType type, Random& random) {
  Dormer dormer{.type = type,
                .width_m = random.uniform(1.6, 2.4),
                .setback_m = random.uniform(0.5, 0.9),
                .front_height_m = random.uniform(0.9, 1.3),
                .pitch_rad = kRadPerDeg * random.uniform(20.0, 35.0)};
  if (type == DormerType::kShed) {
    dormer.pitch_rad = shape.pitch_rad - kRadPerDeg * random.uniform(18.0, 24.0);
    // with a lower front, the dormer meets the main roof well below the ridge
    constexpr double kReach = 0.8;  // share of the distance to the ridge
    const double way_m = 0.5 * shape.width_m - dormer.setback_m;
    const double gain = std::tan(shape.pitch_rad) - std::tan(dormer.pitch_rad);
    dormer.front_height_m = std::min(dormer.front_height_m, kReach * way_m * gain);
  }
  return dormer;
}

/// Adds up to three identical dormers side by side on one side of the roof, as many as fit.
void add_dormers(const HouseShape& shape,
                 DormerType type,
                 Random& random,
                 std::vector<RoofPart>& parts) {
  constexpr double kGapM = 0.8;
  Dormer next = random_dormer(shape, type, random);
  const int most = static_cast<int>(shape.length_m / (next.width_m + kGapM)) - 1;
  const int count = std::min(random.integer(1, 3), most);
  const double spacing_m = shape.length_m / (count + 1);
  for (int i = 1; i <= count; ++i) {
    next.centre_u_m = -0.5 * shape.length_m + spacing_m * i;
    parts.push_back(dormer(shape, next));
  }
}

void steepen_for_dormers(const VillageOptions& options, Random& random, HouseShape& shape) {
  constexpr double kMinPitchDeg = 38.0;  // with a lower pitch, a dormer would reach the ridge
  const double low = std::max(options.min_pitch_deg, kMinPitchDeg);
  shape.pitch_rad = kRadPerDeg * random.uniform(low, std::max(low, options.max_pitch_deg) + 1e-9);
  shape.width_m = random.uniform(8.8, 9.8);
}

std::vector<RoofPart> random_wing_house(HouseShape& shape, Random& random) {
  shape.length_m = random.uniform(10.0, 12.0);
  shape.width_m = random.uniform(7.0, 8.0);
  Wing wing;
  wing.width_m = random.uniform(0.6, 0.85) * shape.width_m;
  wing.length_m = random.uniform(2.5, 4.0);
  const double reach = 0.5 * (shape.length_m - wing.width_m) - 0.9;
  wing.centre_u_m = random.chance(0.5) ? reach : random.uniform(-reach, reach);
  std::vector<RoofPart> parts = l_shaped(shape, wing);
  // the house is centred to stay within its lot
  const Eigen::Vector2d shift(0.0, -0.5 * wing.length_m);
  for (RoofPart& part : parts) part = placed(part, shift, 0.0);
  return parts;
}

std::vector<RoofPart> random_parts(const VillageOptions& options,
                                   RoofType type,
                                   HouseShape& shape,
                                   Random& random) {
  switch (type) {
    case RoofType::kHipped:
      return hipped(shape);
    case RoofType::kFlat:
      return flat(shape);
    case RoofType::kParapet: {
      const double rim_width_m = random.uniform(0.25, 0.4);
      return parapet(shape, rim_width_m, random.uniform(0.3, 0.6));
    }
    case RoofType::kShed:
      shape.pitch_rad = std::min(shape.pitch_rad, kRadPerDeg * random.uniform(10.0, 20.0));
      return shed(shape);
    case RoofType::kLShaped:
      return random_wing_house(shape, random);
    case RoofType::kGabledDormers:
    case RoofType::kShedDormers: {
      steepen_for_dormers(options, random, shape);
      std::vector<RoofPart> parts = gabled(shape);
      add_dormers(shape, type == RoofType::kGabledDormers ? DormerType::kGabled : DormerType::kShed,
                  random, parts);
      return parts;
    }
    default:
      return gabled(shape);
  }
}

bool has_ridge_of_gable(RoofType type) {
  return type == RoofType::kGabled || type == RoofType::kGabledDormers ||
         type == RoofType::kShedDormers || type == RoofType::kHipped;
}

SceneBuilding record(const HouseShape& shape, RoofType type, const Site& site) {
  SceneBuilding building;
  building.id = shape.building_id;
  building.type = type;
  building.pitch_rad =
      type == RoofType::kFlat || type == RoofType::kParapet ? 0.0 : shape.pitch_rad;
  building.ridge_azimuth_rad = std::fmod(site.azimuth_rad + std::numbers::pi, std::numbers::pi);
  return building;
}

void register_parts(const std::vector<RoofPart>& parts, SceneBuilding& building) {
  for (const RoofPart& part : parts) {
    if (part.building_id != building.id) continue;
    building.footprint.push_back(part.walls);
    building.roof_footprint.push_back(part.outline);
  }
}

/// The ground in the frame of the house.
PlanFunction ground_at_house(const Site& site) {
  const PlanFunction& ground = site.ground.height;
  return {Eigen::Rotation2Dd(-site.azimuth_rad) * ground.gradient, ground(site.centre_m)};
}

/// Adds the annexes and small dormers that the options request.
void add_additions(const VillageOptions& options,
                   RoofType type,
                   const Site& site,
                   const HouseShape& shape,
                   Random& clutter,
                   std::vector<RoofPart>& parts) {
  constexpr double kMinRidgeLengthM = 1.5;
  const double ridge_length_m = shape.length_m - (type == RoofType::kHipped ? shape.width_m : 0.0);
  const bool takes_dormers = (type == RoofType::kGabled || type == RoofType::kHipped) &&
                             ridge_length_m >= kMinRidgeLengthM;
  const bool with_dormers = clutter.chance(options.dormer_share);
  if (with_dormers && takes_dormers) add_small_dormers(shape, ridge_length_m, clutter, parts);
  if (!clutter.chance(options.annex_share)) return;
  const ConvexPolygon& body = parts.front().walls;
  add_annex(shape,
            {.centre_m = 0.5 * (body[0] + body[2]),
             .ground = ground_at_house(site),
             .back_is_free = type != RoofType::kLShaped,
             .reach_m = kHouseRadiusM},
            clutter, parts);
}

/// Adds the parts of one house or row to the scene.
void add_parts(const VillageOptions& options,
               const std::vector<RoofPart>& parts,
               const GroundPlane& ground,
               SyntheticScene& scene) {
  const int first_plane_id = static_cast<int>(scene.planes.size());
  add_structure(parts, scene);
  if (!options.with_feet) return;
  const std::vector<PartFace> faces = roof_faces(parts, first_plane_id);
  std::ranges::move(wall_feet(parts, faces, ground), std::back_inserter(scene.lines));
}

void add_single_house(const VillageOptions& options,
                      RoofType type,
                      const Site& site,
                      Random& random,
                      Random& clutter,
                      SyntheticScene& scene) {
  HouseShape shape = random_shape(options, site, random);
  shape.building_id = static_cast<int>(scene.buildings.size());
  std::vector<RoofPart> parts = random_parts(options, type, shape, random);
  if (has_ridge_of_gable(type)) {
    const double chimney_u_m = random.uniform(-0.25, 0.25) * shape.length_m;
    parts.push_back(chimney(shape, chimney_u_m, -1.2, random.uniform(0.3, 0.9)));
  }
  add_additions(options, type, site, shape, clutter, parts);
  for (RoofPart& part : parts) part = placed(part, site.centre_m, site.azimuth_rad);
  SceneBuilding building = record(shape, type, site);
  register_parts(parts, building);
  scene.buildings.push_back(std::move(building));
  add_parts(options, parts, site.ground, scene);
}

constexpr int kRowLength = 3;

/// Wall heights of adjoining houses, each with a step to its neighbour.
std::array<double, kRowLength> row_wall_heights_m(double first_m, Random& random) {
  constexpr double kMinWallHeightM = 2.6;
  std::array<double, kRowLength> heights_m{first_m};
  for (std::size_t i = 1; i < heights_m.size(); ++i) {
    const double step_m = random.uniform(0.4, 1.1);
    const bool down = random.chance(0.5) && heights_m[i - 1] - step_m >= kMinWallHeightM;
    heights_m[i] = heights_m[i - 1] + (down ? -step_m : step_m);
  }
  return heights_m;
}

/// Gabled house number `i` of a row. It has no overhang at party walls, where the lower roof ends
/// at the wall of the higher house.
RoofPart row_part(HouseShape shape, const std::array<double, kRowLength>& heights_m, int i) {
  const auto n = static_cast<std::size_t>(i);
  const bool left_end = i == 0;
  const bool right_end = i + 1 == kRowLength;
  shape.wall_height_m = heights_m[n];
  RoofPart part = gabled(shape).front();
  const double left = left_end ? shape.verge_overhang_m : 0.0;
  const double right = right_end ? shape.verge_overhang_m : 0.0;
  part.outline = rectangle({-0.5 * shape.length_m - left, part.outline[0].y()},
                           {0.5 * shape.length_m + right, part.outline[2].y()});
  // sides of a rectangle: 1 is the right side, 3 the left one
  part.is_joint = {false, !right_end && heights_m[n] < heights_m[n + 1], false,
                   !left_end && heights_m[n] < heights_m[n - 1]};
  const double u = (static_cast<double>(i) - 0.5 * (kRowLength - 1)) * shape.length_m;
  return placed(part, {u, 0.0}, 0.0);
}

/// Adds a row of adjoining gabled houses with steps in height.
void add_row(const VillageOptions& options,
             const Site& site,
             Random& random,
             SyntheticScene& scene) {
  HouseShape shape = random_shape(options, site, random);
  shape.width_m = random.uniform(7.5, 8.5);
  shape.length_m = random.uniform(4.8, 5.1);
  const std::array<double, kRowLength> heights_m = row_wall_heights_m(shape.wall_height_m, random);
  std::vector<RoofPart> parts;
  for (int i = 0; i < kRowLength; ++i) {
    shape.building_id = static_cast<int>(scene.buildings.size());
    parts.push_back(placed(row_part(shape, heights_m, i), site.centre_m, site.azimuth_rad));
    SceneBuilding building = record(shape, RoofType::kRow, site);
    register_parts(parts, building);
    scene.buildings.push_back(std::move(building));
  }
  add_parts(options, parts, site.ground, scene);
}

}  // namespace

void add_house(const VillageOptions& options,
               RoofType type,
               const Site& site,
               Random& random,
               Random& clutter,
               SyntheticScene& scene) {
  if (type == RoofType::kRow) {
    add_row(options, site, random, scene);
  } else {
    add_single_house(options, type, site, random, clutter, scene);
  }
}

}  // namespace ridgeline::simulate
