// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// Limits of the side lengths of a plan.
inline constexpr double kMinExtent_m = 40.0;
inline constexpr double kMaxExtent_m = 2000.0;

/// Lots of 20 m x 20 m in rows on both sides of parallel streets.
struct VillageOptions {
  std::uint64_t seed = 1;
  Eigen::Vector2d extent_m{120.0, 120.0};  ///< extent of the plan in x and y
  std::string crs = "EPSG:25832";
  Eigen::Vector3d origin_m{513000.0, 5403000.0, 250.0};  ///< integers; z: mean height of the ground
  double street_azimuth_deg = 25.0;                      ///< angle of the streets to the x axis
  double aligned_share = 0.4;  ///< share of houses with a main ridge exactly parallel to x
  double built_share = 0.85;   ///< share of lots with a house; the others are parking or gardens
  double terrain_slope_deg = 2.0;  ///< at most 15; the seed determines the direction
  double terrace_step_m = 0.0;     ///< height of the retaining wall between two rows
  double min_pitch_deg = 15.0;     ///< lowest pitch of a pitched roof, at least 10
  double max_pitch_deg = 48.0;     ///< highest pitch, at most 55
  double trees_per_lot = 1.5;      ///< mean number, 0 to 6
  double fence_share = 0.3;        ///< share of the borders between lots that have a fence
  /// The roof types, which are equally probable; empty: all types.
  std::vector<RoofType> roof_types;

  // The options below use separate random streams: with their defaults a village stays
  // byte-identical.
  double annex_share = 0.0;   ///< share of detached houses with a low lean-to or flat annex
  double dormer_share = 0.0;  ///< share of plain gabled and hipped houses with small dormers
  double cars_per_lot =
      0.0;  ///< mean number at the kerb and in gardens, 0 to 4; parking lots have cars of their own
  double garden_wall_share =
      0.0;                 ///< share of the borders between lots without a fence that have a wall
  bool with_feet = false;  ///< true lines at the feet of walls and at retaining walls
  bool with_objects = false;  ///< true lines at the edges of cars and chimneys
};

/// Sets these options to values typical of a suburb.
void set_clutter(VillageOptions& options);

/// Creates a village from a seed: equal options give equal bytes. Buildings are at least 0.5 m
/// apart in plan. Throws std::invalid_argument for an option outside its range.
SyntheticScene make_village(const VillageOptions& options);

}  // namespace ridgeline::simulate
