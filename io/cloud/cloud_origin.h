// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <optional>

namespace ridgeline::io {

/// The origin by one file: the median position, rounded to 100 m by axis, of blocks spread over it;
/// none if it has no finite points. `unit_m`: metres per coordinate unit.
std::optional<LocalFrame> origin_of(const CloudSource& source, const Eigen::Vector3d& unit_m);

/// Whether coordinates are degrees by their size, for all that a reference system says: within
/// [-180, 180] x [-90, 90], and spread over less than 0.2 in plan (20 km in degrees, 20 cm in metres)
/// but more in height. By blocks spread over the file.
bool has_size_of_degrees(const CloudSource& source);

}  // namespace ridgeline::io
