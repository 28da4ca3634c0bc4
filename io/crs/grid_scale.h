// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ridgeline::io {

/// How much longer distances are in the plan of a projected CRS than on the ellipsoid at one place.
struct GridScale {
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();  ///< along east and north of the grid
  double skew = 0.0;     ///< cosine of the angle on the ground between these two
  double lon_deg = 0.0;  ///< the place, in the CRS's own datum
  double lat_deg = 0.0;
  bool in_area_of_use = true;  ///< whether the place lies there; true if the CRS states no area

  /// Whether figures of the plan are right to kMaxScaleError.
  [[nodiscard]] bool is_true() const;
};

/// A figure that is wrong by 1 % is right to its second digit, and intervals of RMS values are
/// wider. It leaves room for grids of whole countries (UTM far outside of its zone: 0.5 %), but not
/// for those of continents or the world.
constexpr double kMaxScaleError = 0.01;

/// The scale at a place, by central differences of the inverse projection. `position`: east and
/// north in the CRS's units. Nothing for a CRS that is unknown or not projected, and for a place
/// that is nowhere on Earth. Throws std::invalid_argument if PROJ cannot read the definition.
std::optional<GridScale> grid_scale(const Crs& crs, const Eigen::Vector2d& position);

/// The scale for messages: "1.515 in x and 1.519 in y at 9.177 E, 48.780 N".
std::string scale_text(const GridScale& scale);

/// The UTM zone of the place, "WGS 84 / UTM zone 32N (EPSG:32632)", in the datum of `crs` if EPSG
/// has its zones.
std::string utm_zone_text(const Crs& crs, const GridScale& scale);

/// Refuses data whose plan is not true to scale: throws IoError with the file's path. Outside of
/// the CRS's area of use its scale says nothing, as data there are in another system than they
/// state. The text that is returned then warns of this; else it is empty. `remedy`: what else could
/// be done than to project the data, ", or ..."; may be empty.
std::string require_true_scale(const std::string& path,
                               const Crs& crs,
                               const Eigen::Vector2d& position,
                               const std::string& remedy);

}  // namespace ridgeline::io
