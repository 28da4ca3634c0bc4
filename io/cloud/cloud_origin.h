// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <optional>

namespace ridgeline::io {

/// The frame derived from the points of one file. Its origin is the median position of points
/// spread over the file, rounded to 100 m per axis. Returns std::nullopt if the file has no finite
/// points. `unit_m`: metres per coordinate unit.
std::optional<LocalFrame> origin_of(const CloudSource& source, const Eigen::Vector3d& unit_m);

/// Whether the magnitude of the coordinates suggests degrees, whatever reference system is stated.
/// Points from blocks spread over the file must lie within [-180, 180] x [-90, 90], span less than
/// 0.2 in plan (20 km in degrees, 20 cm in metres) and span more in height than in plan.
bool has_size_of_degrees(const CloudSource& source);

}  // namespace ridgeline::io
