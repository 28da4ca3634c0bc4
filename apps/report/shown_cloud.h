// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Maximum number of points in a report; larger clouds are thinned.
inline constexpr std::size_t kMaxReportPoints = 200000;

/// The part of a patch's cloud that a report shows: every k-th point, so that at most
/// kMaxReportPoints remain.
struct ShownCloud {
  std::string crs;
  std::uint64_t n_read = 0;    ///< records in the files
  std::size_t n_all = 0;       ///< points kept from these records
  double points_per_m2 = 0.0;  ///< mean over the area that has points
  /// Share of the square metres of the points' bounding box that contain no point; std::nullopt if
  /// only the surroundings of lines were read.
  std::optional<double> no_data_share;
  std::vector<Eigen::Vector3d> x_in_local;
};

ShownCloud shown_cloud(const io::PointCloud& cloud, bool is_masked);

}  // namespace ridgeline::apps
