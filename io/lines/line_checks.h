// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

namespace ridgeline::io {

/// Checks that the lines meet the requirements for judging, however they were read:
///   - no degrees. Throws IoError if the set's CRS is geographic, or if the numbers can only be
///     degrees, whatever CRS is stated or assumed: all within [-180, 180] x [-90, 90] and half of
///     the lines shorter than 0.01 in plan, which is 1 km in degrees but 1 cm in metres. RFC 7946
///     makes degrees the default of GeoJSON, so the numbers must decide.
///   - a unique id for each line, see make_ids_unique().
///   - 3D lines: otherwise throws IoError, which counts by kind what the file contains instead (2D
///     lines, points, null geometries, ...). An empty set is valid.
/// Warns about coordinates that are not finite, heights that are all 0, and what the reader left
/// out, by kind.
void check_lines(LineSet& set);

}  // namespace ridgeline::io
