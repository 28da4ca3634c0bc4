// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/read_cloud.h"

#include "io/cloud/cloud_files.h"
#include "reconstruct/geometry/check.h"

#include <cmath>

namespace ridgeline::io {

LocalFrame suggest_frame(const std::vector<std::string>& paths_or_patterns,
                         const ReadOptions& options) {
  ReadOptions unframed = options;
  unframed.frame.reset();
  return CloudFiles(paths_or_patterns, unframed).frame();
}

Eigen::AlignedBox3d plan_bounds(std::span<const double> bounds) {
  check(bounds.size() == 4, "bounds: ", bounds.size(),
        " numbers; must be x_min, y_min, x_max, y_max");
  check(bounds[0] <= bounds[2] && bounds[1] <= bounds[3],
        "bounds: x_min, y_min, x_max, y_max must not be inverted or NaN");
  return {Eigen::Vector3d(bounds[0], bounds[1], -HUGE_VAL),
          Eigen::Vector3d(bounds[2], bounds[3], HUGE_VAL)};
}

PointCloud read_cloud(const std::vector<std::string>& paths_or_patterns,
                      const ReadOptions& options) {
  check(!options.near || options.frame,
        "read_cloud: near is set but frame is not; the mask is in local coordinates");
  CloudFiles files(paths_or_patterns, options);
  PointCloud cloud = files.read(options.near);
  if (!cloud.points.empty() || files.unread_paths().empty()) return cloud;
  files.distrust_headers();  // if no point is found at all, a wrong header is likely
  return files.read(options.near);
}

}  // namespace ridgeline::io
