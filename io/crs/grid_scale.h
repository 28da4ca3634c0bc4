// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ridgeline::io {

/// The ratio of distances in the plan of a projected CRS to those on the ellipsoid, at one place.
struct GridScale {
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();  ///< along east and north of the grid
  double skew = 0.0;     ///< cosine of the angle between east and north of the grid on the ground
  double lon_deg = 0.0;  ///< the place, in the CRS's own datum
  double lat_deg = 0.0;
  bool in_area_of_use = true;  ///< whether the place lies in it; true if the CRS states none

  /// Whether distances in the plan are correct to within kMaxScaleError.
  [[nodiscard]] bool is_true() const;
};

/// A value with an error of 1 % is correct to its second digit, and confidence intervals of RMS
/// values are wider. The limit leaves room for grids of whole countries (UTM far outside its zone:
/// 0.5 %), but not for those of continents or the world.
constexpr double kMaxScaleError = 0.01;

/// The scale at a place, by central differences of the inverse projection. `position`: east and
/// north in the CRS's units. std::nullopt for a CRS that is unknown or not projected, and for a
/// position that is not on Earth. Throws std::invalid_argument if PROJ cannot read the definition.
std::optional<GridScale> grid_scale(const Crs& crs, const Eigen::Vector2d& position);

/// The scale for messages: "1.515 in x and 1.519 in y at 9.177 E, 48.780 N".
std::string scale_text(const GridScale& scale);

/// The UTM zone of the place, "WGS 84 / UTM zone 32N (EPSG:32632)"; in the datum of `crs` if EPSG
/// has UTM zones for it.
std::string utm_zone_text(const Crs& crs, const GridScale& scale);

/// Throws IoError with the file's path if the plan is not true to scale. Outside the CRS's area of
/// use the scale is meaningless, because such data are not in the stated system; the function then
/// returns a warning. Otherwise the returned text is empty. `remedy`: an alternative to projecting
/// the data, ", or ..."; may be empty.
std::string require_true_scale(const std::string& path,
                               const Crs& crs,
                               const Eigen::Vector2d& position,
                               const std::string& remedy);

}  // namespace ridgeline::io
