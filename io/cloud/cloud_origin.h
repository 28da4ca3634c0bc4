// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <memory>
#include <span>

namespace ridgeline::io {

/// The frame of a run: the median position, rounded to 100 m by axis, of blocks spread over the
/// first source that has finite points; zero if none has. `unit_m` holds the units of each source.
LocalFrame cloud_origin(std::span<const std::unique_ptr<CloudSource>> sources,
                        std::span<const Eigen::Vector3d> unit_m);

}  // namespace ridgeline::io
