// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <functional>
#include <optional>
#include <string>

namespace ridgeline::io {

/// A line of a map with the results of its judgement. Texts missing from the map are empty.
struct MapLine {
  std::string id, line_class, kind;
  std::string status;  ///< status of the judgement; empty in a map of lines that are not judged
  std::optional<double> length_m, mean_distance_m, max_distance_m;
  std::optional<int> n_images;
  Segment3 segment_in_map{};  ///< in the units of the map
};

/// Visits the lines of a map written by results::write_judged_map(), or of a GeoPackage written by
/// write_lines(), in their order. Only one line is held at a time. Features that are not segments
/// are skipped. Throws IoError if the file is missing or is not such a map.
void for_each_map_line(const std::string& path, const std::function<void(const MapLine&)>& visit);

}  // namespace ridgeline::io
