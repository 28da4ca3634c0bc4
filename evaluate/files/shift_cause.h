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

/// Where shifted lines lie, and by which systems and cameras.
struct ShiftPlace {
  Eigen::Vector3d x_in_local = Eigen::Vector3d::Zero();  ///< a place amid the lines
  LocalFrame frame;
  io::Crs crs;                                       ///< of the cloud or the lines; may be unknown
  Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();  ///< metres per unit of `crs`
  std::string geoid_path;                            ///< grid of the user; may be empty
  const std::optional<io::Patch>* patch = nullptr;   ///< its cameras
};

/// A clause on what explains a significant shift, "" if nothing known does:
///   - geoid against ellipsoid: the shift in height is the height of the geoid, see io::geoid_at();
///     if that cannot be known, the clause says which grid is missing;
///   - half a pixel: the shift in plan is half a row and half a column of every image on the
///     ground, and there is none in height.
/// A swapped or mirrored axis moves no two lines alike, so that no constant shift tells of it.
/// Throws IoError as io::require_geoid_grid().
std::string likely_cause(const evaluate::ConstantShift& shift, const ShiftPlace& place);

}  // namespace ridgeline::results
