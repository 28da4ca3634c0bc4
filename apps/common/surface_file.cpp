// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/surface_file.h"

#include "apps/common/patch_views.h"
#include "io/cloud/las_writer.h"
#include "reconstruct/geometry/transformed.h"

namespace ridgeline::apps {

void write_surface(const std::string& file,
                   const io::PatchFile& patch,
                   const std::vector<Eigen::Vector3d>& points_in_local) {
  io::write_las(file, transformed(points_in_local, io::single_return), patch_frame(patch),
                patch.crs);
}

}  // namespace ridgeline::apps
