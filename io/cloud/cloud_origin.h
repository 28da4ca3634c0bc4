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

}  // namespace ridgeline::io
