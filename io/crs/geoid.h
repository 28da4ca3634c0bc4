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
  double accuracy_m = 0.0;  ///< heights of a national system lie within about this of the geoid
};

/// What is known of the geoid at a place.
struct GeoidAnswer {
  std::optional<GeoidHeight> height;
  std::vector<std::string>
      missing;  ///< grids that would tell more and are not there; sorted, each once
};

/// Throws IoError unless PROJ reads the file as a grid of the geoid's heights above the ellipsoid
/// (GTX, GeoTIFF).
void require_geoid_grid(const std::string& path);

/// The geoid by the first of these that holds the place:
///   - the user's grid `path`, if it is not empty;
///   - the grid that PROJ's data base names for the vertical part of `crs`, if there is one;
///   - EGM96, which is worldwide, and a metre or two off the heights of a country.
/// A grid that is not there is named in `missing`; no height is made up for it. `position`: east
/// and north in the units of `crs`. The answer is empty for a CRS that is unknown or not projected.
/// Throws std::invalid_argument if PROJ cannot read the definition of `crs`, and IoError as
/// require_geoid_grid().
GeoidAnswer geoid_at(const Crs& crs, const Eigen::Vector2d& position, const std::string& path);

}  // namespace ridgeline::io
