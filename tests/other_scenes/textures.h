// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/scene_model.h"

#include <Eigen/Core>

namespace ridgeline::other {

/// Reflectance (red, green, blue, 0..1) of a face at texture coordinates in metres: u along its
/// lower side, v up from it.
Eigen::Vector3d reflectance(const Look& look, double u, double v);

/// Of the leaves of a tree or a hedge at `x`.
Eigen::Vector3d leaf_reflectance(const Look& look, const Eigen::Vector3d& x);

/// Of the ground in plan.
Eigen::Vector3d ground_reflectance(const Scene& scene, const Eigen::Vector2d& x);

/// Share of light that a material reflects as a mirror would, 0..1.
double gloss(Material material);

/// Width of the zinc gutter at the lower side of tiled roof planes, metres along v from 0.
constexpr double kGutter_m = 0.13;
/// Pitch of the seams of metal roofs, metres along u from 0.
constexpr double kSeamPitch_m = 0.6;
/// Photovoltaic modules: their pitch along u and v, metres from 0.
constexpr double kModuleWidth_m = 1.05, kModuleHeight_m = 1.7;
/// Windows of a storey: pitch along u, and the heights v of their lower and upper borders.
constexpr double kWindowPitch_m = 2.6, kWindowFoot_m = 0.9, kWindowHead_m = 2.2;
constexpr double kStorey_m = 2.8;
constexpr double kWallFoot_m = 1.5;  ///< walls begin this far below their floor

}  // namespace ridgeline::other
