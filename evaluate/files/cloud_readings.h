// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"
#include "io/cloud/point_cloud.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace ridgeline::results {

/// Totals over all readings of a cloud: a point that two readings keep counts twice.
struct CloudReadings {
  std::size_t n_batches = 0;
  std::uint64_t n_kept = 0;
  io::PointCloud cloud;  ///< without points: reference system, units, counts, warnings
};

/// Adds the points of one reading, whose number is `n_kept`, to the totals. `part` may have lost
/// its points.
void add_reading(io::PointCloud part, std::uint64_t n_kept, CloudReadings& sum);

/// Throws IoError if the files have no points, or if the options keep none of them wherever they
/// lie.
void require_points(const io::PointCloud& cloud, const std::string& path);

/// The message if no point lies within the bounds of the options.
std::string no_point_in_bounds(const io::CloudFiles& cloud);

}  // namespace ridgeline::results
