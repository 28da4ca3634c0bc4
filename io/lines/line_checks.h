// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

namespace ridgeline::io {

/// Throws IoError if the set's CRS is geographic, or if the numbers can only be degrees, whatever CRS
/// is stated or assumed: all within [-180, 180] x [-90, 90] and half of the lines shorter than 0.01 in plan,
/// which is 1 km in degrees but 1 cm in metres. RFC 7946 makes degrees the default of GeoJSON, so
/// the numbers must decide.
void refuse_degrees(const LineSet& set);

/// Warns of what a judgement should know of the coordinates: not finite, without height, all
/// heights 0, ids that occur twice. Throws IoError if no line has a height.
void add_coordinate_warnings(LineSet& set);

}  // namespace ridgeline::io
