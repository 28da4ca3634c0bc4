// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The height of the geoid above the ellipsoid at a place.
struct GeoidHeight {
  double height_m = 0.0;
  std::string grid;         ///< the grid's name
  double accuracy_m = 0.0;  ///< heights of a national system agree with the geoid to about this
};

/// The result of geoid_at().
struct GeoidAnswer {
  std::optional<GeoidHeight> height;
  std::vector<std::string> missing;  ///< grids that would give a better answer but are not
                                     ///< available; sorted, without duplicates
};

/// Throws IoError unless PROJ can read the file as a grid of geoid heights above the ellipsoid
/// (GTX, GeoTIFF).
void require_geoid_grid(const std::string& path);

/// The geoid height from the first of these that covers the place:
///   - the user's grid `path`, if it is not empty;
///   - the grid that PROJ's database gives for the vertical part of `crs`, if there is one;
///   - EGM96, which is worldwide and differs from national heights by a metre or two.
/// Unavailable grids are listed in `missing`; heights are never invented. `position`: east and
/// north in the units of `crs`. The answer is empty for a CRS that is unknown or not projected.
/// Throws std::invalid_argument if PROJ cannot read the definition of `crs`, and IoError under the
/// same conditions as require_geoid_grid().
GeoidAnswer geoid_at(const Crs& crs, const Eigen::Vector2d& position, const std::string& path);

}  // namespace ridgeline::io
