// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <functional>
#include <optional>
#include <string>

namespace ridgeline::io {

/// A line of a map, with what its judgement says of it. Texts that the map does not hold are empty.
struct MapLine {
  std::string id, line_class, kind;
  std::string status;  ///< of the judgement; empty in a map of lines that are not judged
  std::optional<double> length_m, mean_distance_m, max_distance_m;
  std::optional<int> n_images;
  Segment3 segment_in_map{};  ///< in the units of the map
};

/// Visits the lines of a map that results::write_judged_map() made, or of a GeoPackage that
/// write_lines() made, in their order. One line is held at a time. Features that are no segment are
/// passed over. Throws IoError for a file that is missing or is no such map.
void for_each_map_line(const std::string& path, const std::function<void(const MapLine&)>& visit);

}  // namespace ridgeline::io
