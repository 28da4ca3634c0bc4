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

/// A line, or a building of a model, that is wrong, and what mending it would gain. Local metres.
struct ToFix {
  bool is_building = false;
  std::string id;
  std::string building;  ///< of a line
  std::string kind;      ///< of a line: roof_kind(); of a building: its verdict
  double gain = 0.0;     ///< share of the squares that make the RMS of the lines, or of the points
                         ///< over the roofs
  std::optional<double>
      off_m;  ///< mean distance of a line; RMS of the points over a roof, in height
  /// What to add to the coordinates at which it was judged: of a ridge by its two planes, of
  /// another line in height only, as one plane does not tell the plan; of a building that is off as
  /// a whole.
  std::optional<double> move_x_m, move_y_m, move_z_m;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< the middle
};

/// What to fix first of line file `i`: the buildings with another verdict than right, and the lines
/// of other buildings that are farther off than 0.3 m, or than SummaryOptions::gross_m if that is
/// less. The largest gain comes first.
std::vector<ToFix> to_fix(const JudgedFiles& judged, std::size_t i);

inline constexpr const char* kToFixName = "to_fix.csv";

/// `to_fix.csv`: method,rank,what,id,building,kind,gain_share,off_m,move_x_m,move_y_m,move_z_m.
/// `what` is line or building.
/// @param lists  of each line file
std::string to_fix_csv(const JudgedFiles& judged, const std::vector<std::vector<ToFix>>& lists);

/// The list as marks of a map.
io::MapLayer to_fix_layer(const std::vector<ToFix>& list, const ToMap& to_map);

}  // namespace ridgeline::results
