// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Most points that a report shows; larger clouds are thinned.
inline constexpr std::size_t kMaxReportPoints = 200000;

/// What a report shows of a patch's cloud: every k-th point, so that at most kMaxReportPoints stay.
struct ShownCloud {
  std::string crs;
  std::uint64_t n_read = 0;    ///< records in the files
  std::size_t n_all = 0;       ///< points kept of these records
  double points_per_m2 = 0.0;  ///< mean where there are points
  /// Share of the square metres of the points' box without any point; nothing if only the
  /// surroundings of lines were read.
  std::optional<double> no_data_share;
  std::vector<Eigen::Vector3d> x_in_local;
};

ShownCloud shown_cloud(const io::PointCloud& cloud, bool is_masked);

}  // namespace ridgeline::apps
