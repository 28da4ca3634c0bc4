// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/cloud_readings.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ridgeline::results {

void add_reading(io::PointCloud part, std::uint64_t n_kept, CloudReadings& sum) {
  ++sum.n_batches;
  sum.n_kept += n_kept;
  io::PointCloud& cloud = sum.cloud;
  cloud.frame = part.frame;
  cloud.crs = std::move(part.crs);
  cloud.horizontal_unit_m = part.horizontal_unit_m;
  cloud.vertical_unit_m = part.vertical_unit_m;
  for (const auto count :
       {&io::PointCloud::n_read, &io::PointCloud::n_dropped_class,
        &io::PointCloud::n_dropped_withheld, &io::PointCloud::n_dropped_return,
        &io::PointCloud::n_dropped_bounds, &io::PointCloud::n_dropped_non_finite}) {
    cloud.*count += part.*count;
  }
  for (std::string& warning : part.warnings) {
    if (std::ranges::find(cloud.warnings, warning) == cloud.warnings.end()) {
      cloud.warnings.push_back(std::move(warning));
    }
  }
}

void require_points(const io::PointCloud& cloud, const std::string& path) {
  if (cloud.n_read == 0) {
    throw io::IoError(path, "has no points");
  }
  const std::uint64_t filtered = cloud.n_dropped_class + cloud.n_dropped_withheld +
                                 cloud.n_dropped_return + cloud.n_dropped_non_finite;
  if (filtered < cloud.n_read) return;
  throw io::IoError(
      path, fmt::format("none of {} points are left: {} dropped by class, {} withheld, {} not last "
                        "returns, {} not finite; `ridgeline info` lists its classes",
                        cloud.n_read, cloud.n_dropped_class, cloud.n_dropped_withheld,
                        cloud.n_dropped_return, cloud.n_dropped_non_finite));
}

std::string no_point_in_bounds(const io::CloudFiles& cloud) {
  return fmt::format(
      "no point lies within `bounds`; must be in the cloud's own coordinates, [{}], unit {}",
      io::describe(cloud.crs()).name, io::unit_text(cloud.unit_m().x() * cloud.plan_scale().x()));
}

}  // namespace ridgeline::results
