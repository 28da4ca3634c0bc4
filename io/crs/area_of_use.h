// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The distance, m, of a position from the area in which a projected or geographic CRS is meant to
/// be used: 0 inside, infinity if the position is nowhere on Earth, std::nullopt if the CRS is
/// neither, or PROJ knows no area for it. `x_in_crs`: east, north in the units of the CRS.
std::optional<double> distance_from_area_of_use_m(const Crs& crs, const Eigen::Vector2d& x_in_crs);

/// Compares positions with the area in which their projected system is meant to be used. Positions
/// outside were stated without an offset, or in another system.
/// `x_m`: metres in the CRS; their median by coordinate is compared.
/// Returns a warning if that position is up to 300 km outside the area; empty if it is inside, if
/// the CRS is unknown or not projected, and if PROJ knows no area for it. Throws
/// std::invalid_argument if the position is farther outside or nowhere on Earth.
std::string check_area_of_use(const Crs& crs, const std::vector<Eigen::Vector3d>& x_m);

}  // namespace ridgeline::io
