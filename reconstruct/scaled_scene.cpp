// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scaled_scene.h"

#include <Eigen/LU>

namespace ridgeline::reconstruct {
namespace {

/// Ideal pixels of a view from those of the view at_scale_of_edges().
Eigen::Matrix3d file_from_scaled(const View& view) {
  return image_from_reduced(view, scale_of_edges(view));
}

}  // namespace

Scene at_scale_of_edges(const Scene& scene) {
  Scene scaled{{}, scene.height_range_in_local_m, scene.frame};
  for (const View& view : scene.views) scaled.views.push_back(at_scale_of_edges(view));
  return scaled;
}

ScaledPair::ScaledPair(const StereoPair& pair_in_files)
    : views{at_scale_of_edges(*pair_in_files.views[0]), at_scale_of_edges(*pair_in_files.views[1])},
      height_range_in_local_m(pair_in_files.height_range_in_local_m) {}

void take_to_pixels_of_files(const StereoPair& pair_in_files, Surface& surface) {
  for (std::size_t i = 0; i < pair_in_files.views.size(); ++i) {
    Eigen::Matrix3d& rectified_from_ideal = surface.rectification.rectified_from_ideal[i];
    rectified_from_ideal =
        rectified_from_ideal * file_from_scaled(*pair_in_files.views[i]).inverse();
  }
}

Surface at_scale_of_edges(const StereoPair& pair_in_files, Surface surface) {
  for (std::size_t i = 0; i < pair_in_files.views.size(); ++i) {
    Eigen::Matrix3d& rectified_from_ideal = surface.rectification.rectified_from_ideal[i];
    rectified_from_ideal = rectified_from_ideal * file_from_scaled(*pair_in_files.views[i]);
  }
  return surface;
}

}  // namespace ridgeline::reconstruct
