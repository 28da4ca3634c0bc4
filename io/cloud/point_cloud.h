// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {

/// One laser return, local coordinates in metres. 32 bytes: the memory budget of a point.
struct CloudPoint {
  double x, y, z;
  std::uint16_t intensity;
  std::uint8_t classification;  ///< ASPRS: 2 ground, 6 building; 0 if the file has none
  std::uint8_t return_number;
  std::uint8_t number_of_returns;
  std::uint8_t flags;  ///< bit 0 synthetic, 1 key point, 2 withheld, 3 overlap
  std::uint16_t source_id;
};
static_assert(sizeof(CloudPoint) == 32);

/// A point that is the only return of its pulse, without class or intensity.
inline CloudPoint single_return(const Eigen::Vector3d& x_in_local) {
  return {.x = x_in_local.x(),
          .y = x_in_local.y(),
          .z = x_in_local.z(),
          .intensity = 0,
          .classification = 0,
          .return_number = 1,
          .number_of_returns = 1,
          .flags = 0,
          .source_id = 0};
}

/// Points of all files of a run in one local frame, in file order and record order.
struct PointCloud {
  LocalFrame frame;
  Crs crs;
  std::vector<CloudPoint> points;
  std::vector<std::string> warnings;  ///< see shared_warnings()
  /// Metres per unit of the files' coordinates, already applied to the points: 1 unless the CRS
  /// is in feet.
  double horizontal_unit_m = 1.0;
  double vertical_unit_m = 1.0;
  std::uint64_t n_read = 0;           ///< records in the files
  std::uint64_t n_dropped_class = 0;  ///< dropped by the class filter (default: 7 and 18, noise)
  std::uint64_t n_dropped_withheld = 0;
  std::uint64_t n_dropped_return = 0;  ///< dropped by --last-returns
  std::uint64_t n_dropped_bounds = 0;  ///< dropped by --bounds or because no line is near
  std::uint64_t n_dropped_non_finite = 0;
  std::uint64_t n_dropped_share = 0;  ///< dropped only because of ReadOptions::share
};

}  // namespace ridgeline::io
