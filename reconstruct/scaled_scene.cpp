// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scaled_scene.h"

#include "reconstruct/geometry/transformed.h"
#include "reconstruct/ok2011/extract/edge_blur.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
Scene reduced(const Scene& scene, std::span<const int> factors) {
  Scene scaled{{}, scene.height_range_in_local_m, scene.frame};
  for (std::size_t i = 0; i < scene.views.size(); ++i)
    scaled.views.push_back(reduced(scene.views[i], factors[i]));
  return scaled;
}

Scene at_scale_of_edges(const Scene& scene) {
  return reduced(scene, transformed(scene.views, scale_of_edges));
}

int scale_of_blur(const View& view) {
  const double blur_px = edge_blur_px(view.image, extracted(view.segments)).value_or(0.0);
  return std::max(scale_of_edges(view), static_cast<int>(std::lround(blur_px)));
}

ScaledPair::ScaledPair(const StereoPair& pair_in_files)
    : views{at_scale_of_edges(*pair_in_files.views[0]), at_scale_of_edges(*pair_in_files.views[1])},
      height_range_in_local_m(pair_in_files.height_range_in_local_m) {}

void take_to_pixels_of_files(const StereoPair& pair_in_files, Surface& surface) {
  for (std::size_t i = 0; i < pair_in_files.views.size(); ++i) {
    Eigen::Matrix3d& rectified_from_ideal = surface.rectification.rectified_from_ideal[i];
    rectified_from_ideal =
        rectified_from_ideal *
        image_from_reduced(*pair_in_files.views[i], scale_of_edges(*pair_in_files.views[i]))
            .inverse();
  }
}

Surface reduced(const StereoPair& pair_in_files,
                Surface surface,
                const std::array<int, 2>& factors) {
  for (std::size_t i = 0; i < pair_in_files.views.size(); ++i) {
    Eigen::Matrix3d& rectified_from_ideal = surface.rectification.rectified_from_ideal[i];
    rectified_from_ideal =
        rectified_from_ideal * image_from_reduced(*pair_in_files.views[i], factors[i]);
  }
  return surface;
}

}  // namespace ridgeline::reconstruct
