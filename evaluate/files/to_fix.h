// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/files/map_layers.h"
#include "io/gdal/geopackage_writer.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// A wrong line, or a wrong building of a model, and the gain from fixing it. Local metres.
struct ToFix {
  bool is_building = false;
  std::string id;
  std::string building;  ///< of a line
  std::string kind;      ///< of a line: roof_kind(); of a building: its verdict
  double gain = 0.0;  ///< share of the sum of squares of the lines, or of the points over the roofs
  /// Mean distance of a line; for a building, RMS of the points over the roof, in height.
  std::optional<double> off_m;
  /// The correction to the judged coordinates: for a ridge, derived from its two planes; for any
  /// other line in height only, because one plane does not determine the position in plan; for a
  /// building, if it is shifted as a whole.
  std::optional<double> move_x_m, move_y_m, move_z_m;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< the middle
};

/// What to fix first in line file `i`: the judged buildings whose verdict is not `right`, and lines
/// outside these buildings that are more than 0.3 m off (or SummaryOptions::gross_m if less). The
/// largest gain comes first.
std::vector<ToFix> to_fix(const JudgedFiles& judged, std::size_t i);

inline constexpr const char* kToFixName = "to_fix.csv";

/// `to_fix.csv`: method,rank,what,id,building,kind,gain_share,off_m,move_x_m,move_y_m,move_z_m.
/// `what` is line or building.
/// @param lists  for each line file
std::string to_fix_csv(const JudgedFiles& judged, const std::vector<std::vector<ToFix>>& lists);

/// The list as point markers for a map.
io::MapLayer to_fix_layer(const std::vector<ToFix>& list, const ToMap& to_map);

}  // namespace ridgeline::results
