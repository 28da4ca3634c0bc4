// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/constant_shift.h"
#include "io/crs/crs.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ridgeline::results {

/// Position, reference system and cameras of shifted lines.
struct ShiftPlace {
  Eigen::Vector3d x_in_local = Eigen::Vector3d::Zero();  ///< a place amid the lines
  LocalFrame frame;
  io::Crs crs;                                       ///< of the cloud or the lines; may be unknown
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();  ///< metres per unit of `crs`
  std::string geoid_path;                            ///< grid of the user; may be empty
  const std::optional<io::Patch>* patch = nullptr;   ///< its cameras
};

/// A clause that explains a significant shift; "" if no known cause fits:
///   - geoid versus ellipsoid: the height shift equals the geoid height, see io::geoid_at(); if the
///     geoid height is unavailable, the clause names the missing grid;
///   - half a pixel: the shift in plan is half a row and half a column of every image on the
///     ground, without a shift in height.
/// A swapped or mirrored axis moves every line differently and so does not cause a constant shift.
/// Throws IoError under the same conditions as io::require_geoid_grid().
std::string likely_cause(const evaluate::ConstantShift& shift, const ShiftPlace& place);

}  // namespace ridgeline::results
