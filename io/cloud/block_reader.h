// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/point_filter.h"
#include "io/crs/coordinate_steps.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <vector>

namespace ridgeline::io {

struct ReadSummary {
  std::uint64_t n_read = 0;
  DropCounts drops;
  Eigen::AlignedBox3d extent_in_world;  ///< box of all decoded finite points, kept or not; metres
  CoordinateSteps steps;                ///< steps of all decoded points
  bool has_whole_extent = true;         ///< false if blocks outside the region were skipped
};

/// Appends the kept points of a source, in file order; blocks are decoded in parallel. Stops within
/// a few blocks once there are more than `max_points`.
/// Throws IoError for a damaged block (the first in file order) or a coordinate beyond 1e8 m.
ReadSummary append_points(const CloudSource& source,
                          const LocalFromFile& local_from_file,
                          const PointFilter& filter,
                          std::vector<CloudPoint>& points,
                          std::uint64_t max_points = std::numeric_limits<std::uint64_t>::max());

/// How many points append_points() would append.
std::uint64_t count_kept(const CloudSource& source,
                         const LocalFromFile& local_from_file,
                         const PointFilter& filter);

/// The box of the points that append_points() would append, local metres; empty if there are none.
Eigen::AlignedBox3d kept_extent(const CloudSource& source,
                                const LocalFromFile& local_from_file,
                                const PointFilter& filter);

}  // namespace ridgeline::io
