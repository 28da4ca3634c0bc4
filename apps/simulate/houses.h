// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/roof_part.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::simulate {

/// A house in its own frame: u along the main ridge, v across, origin in the middle of its main
/// body. Heights, however, are local.
struct HouseShape {
  double length_m = 12.0;  ///< length of the main body's walls, along u
  double width_m = 9.0;    ///< width of the main body's walls, along v
  double pitch_rad = 0.6;
  double eave_overhang_m = 0.4;
  double verge_overhang_m = 0.3;
  double slab_thickness_m = 0.25;
  double floor_z_m = 0.0;      ///< lowest ground at the house
  double wall_height_m = 5.0;  ///< from the floor to the roof plane above the side wall
  int building_id = 0;
};

/// The parts of one house. All sizes must be positive, and pitch_rad in (0, pi/2) unless the roof
/// is flat.
std::vector<RoofPart> gabled(const HouseShape& shape);
std::vector<RoofPart> hipped(const HouseShape& shape);
std::vector<RoofPart> flat(const HouseShape& shape);
/// A flat roof inside a rim of `rim_width_m` that rises by `rim_height_m`.
std::vector<RoofPart> parapet(const HouseShape& shape, double rim_width_m, double rim_height_m);
/// A single-plane roof that rises along +v.
std::vector<RoofPart> shed(const HouseShape& shape);

/// A gabled main body with a gabled wing along +v. All eaves are at the same height, so two valleys
/// start at the inner corners.
struct Wing {
  double centre_u_m = 0.0;
  double width_m = 6.0;   ///< at most the width of the main body
  double length_m = 4.0;  ///< reach beyond the main body's wall
};
std::vector<RoofPart> l_shaped(const HouseShape& shape, const Wing& wing);

enum class DormerType : std::uint8_t { kGabled, kShed };

/// A dormer on the +v side of a gabled house. The front wall stands `setback_m` behind the side
/// wall.
struct Dormer {
  DormerType type = DormerType::kGabled;
  double centre_u_m = 0.0;
  double width_m = 2.0;
  double setback_m = 0.6;
  double front_height_m = 1.2;  ///< height of its eave above the main roof at the front
  double pitch_rad = 0.5;
};
RoofPart dormer(const HouseShape& shape, const Dormer& dormer);

/// A chimney through the -v side of the roof, `above_ridge_m` higher than the main ridge.
RoofPart chimney(const HouseShape& shape, double u_m, double v_m, double above_ridge_m);

/// Height of the main ridge of a gabled roof.
double ridge_z_m(const HouseShape& shape);

/// Turns a part by the azimuth and moves it in plan.
RoofPart placed(const RoofPart& part, const Eigen::Vector2d& position_m, double azimuth_rad);

}  // namespace ridgeline::simulate
