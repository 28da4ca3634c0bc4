// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/scene.h"
#include "reconstruct/geometry/field.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// Maximum number of strips in one direction, and of frames in a strip.
inline constexpr int kMaxStripsOrFrames = 99;

/// The strips of a photogrammetric block. Camera, flying height and errors are those of
/// FlightOptions with whole frames.
struct BlockOptions {
  int num_strips = 2;            ///< along x, 1 to kMaxStripsOrFrames
  int num_frames = 3;            ///< per strip along x, 2 to kMaxStripsOrFrames
  int num_cross_strips = 0;      ///< along y
  double forward_overlap = 0.6;  ///< of neighbouring frames in a strip
  double side_overlap = 0.3;     ///< of neighbouring strips

  static constexpr auto fields() {
    using O = BlockOptions;
    return std::tuple{Field{"cross_strips", &O::num_cross_strips, 0, kMaxStripsOrFrames,
                            "further strips along y, with as many frames each as the block needs"},
                      Field{"forward_overlap", &O::forward_overlap, 0.5, 0.95,
                            "share of its columns that the next frame of the strip shows again"},
                      Field{"side_overlap", &O::side_overlap, 0.0, 0.95,
                            "share of their rows that the next strip shows again"}};
  }
};

/// The extent of the plan that two frames of each strip show, in whole metres, allowing for the
/// objects on it and the errors of the flight. The plan lies in the middle of the block. Throws
/// std::invalid_argument for an option outside its range, a flight without whole frames and an
/// extent that a village cannot have.
Eigen::Vector2d block_extent_m(const BlockOptions& block,
                               const FlightOptions& flight,
                               double terrain_slope_deg);

/// The frames in the order of the flight: the strips along x from south to north, in alternating
/// directions, then those along y from east to west. The flying height follows the ground. Ids are
/// STRIP_FRAME, both numbered from 1 with at least two digits.
std::vector<PlannedView> block_views(const BlockOptions& block,
                                     const FlightOptions& flight,
                                     const SyntheticScene& scene);

/// Throws std::invalid_argument unless every place in an area of the plan (local) is shown by at
/// least two views, at the lowest and at the highest height of the scene above the mean terrain.
void check_shown_twice(const SyntheticScene& scene,
                       std::span<const AerialView> views,
                       const Eigen::AlignedBox2d& area_m);

}  // namespace ridgeline::simulate
