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

PointCloud read_cloud(const std::vector<std::string>& paths_or_patterns,
                      const ReadOptions& options) {
  check(!options.near || options.frame,
        "read_cloud: near is set but frame is not; the mask is in local coordinates");
  return CloudFiles(paths_or_patterns, options).read(options.near);
}

}  // namespace ridgeline::io
