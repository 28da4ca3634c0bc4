// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/judge/judged_planes.h"
#include "evaluate/statistics/evaluation.h"
#include "io/lines/line_set.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// The name of a method's map, "judged.METHOD.gpkg".
std::string map_name(const std::string& method);

/// The columns of the layer `lines` in addition to the common ones.
enum class MapSchema : std::uint8_t {
  kPlain,
  kFkb,  ///< objtype, nøyaktighet, nøyaktighetHøyde (cm), Norwegian FKB-Bygning
};

/// The schema named "plain" or "fkb". Throws std::invalid_argument for another name.
MapSchema map_schema_named(const std::string& name);

/// A warning about columns of the line file for which the map has no room; empty if all fit.
std::string left_out_of_map(const io::LineSet& set);

/// Writes the judged lines of file `i` as a map (GeoPackage), in the reference system of the lines
/// or, if unknown, of the cloud, with coordinates in its units:
///   lines    the lines, coloured by distance, with every column of their file (NAME_in if the name
///            is taken), `source_fid`, `part` and the results; moved_x_m, moved_y_m and moved_z_m
///            if the lines were moved before they were judged
///   planes   the LIDAR planes that they were judged against, as the hulls of their points
///   vectors  from the midpoint of each judged line to its foot point on each of its planes
///   to_fix   what to fix first, see to_fix()
///   buildings, faces  of a model, see model_layers()
///   missing, missing_roofs  if the lines were compared with the edges of the scan
/// Throws IoError if the file cannot be written.
void write_judged_map(const std::string& path,
                      const JudgedFiles& judged,
                      std::size_t i,
                      MapSchema schema);

}  // namespace ridgeline::results
