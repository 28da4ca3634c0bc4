// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/surface_file.h"

#include "io/cloud/las_writer.h"
#include "reconstruct/geometry/transformed.h"

namespace ridgeline::apps {

void write_surface(const std::string& file,
                   const std::vector<Eigen::Vector3d>& points_in_local,
                   const LocalFrame& frame,
                   const io::Crs& crs) {
  io::write_las(file, transformed(points_in_local, io::single_return), frame, crs);
}

}  // namespace ridgeline::apps
