// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scaled_scene.h"

#include "reconstruct/extract/ok2011/edge_blur.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Adds the error due to objects within the blur of an edge. Of 0.1, 0.2 and 0.3 px, 0.2 gives the
/// smallest median error of the lines in the villages with seeds 1 to 3 at a blur of 2 px, and
/// realistic sigmas.
/// @param segment  in pixels of the size of its blur
void add_error_of_blur(UncertainSegment2& segment) {
  constexpr double kMoved_px = 0.2;
  constexpr double kTurned_px = 0.15;  // an end relative to the middle
  const double half_length_px = 0.5 * length(segment.segment);
  segment.sigma_q_px = std::hypot(segment.sigma_q_px, kMoved_px);
  segment.sigma_phi_rad = std::hypot(segment.sigma_phi_rad, kTurned_px / half_length_px);
}

}  // namespace

Scene at_scale_of_edges(const Scene& scene) {
  Scene scaled{{}, scene.height_range_in_local_m, scene.frame};
  for (const View& view : scene.views) scaled.views.push_back(at_scale_of_edges(view));
  return scaled;
}

int scale_of_blur(const View& view) {
  const double blur_px = blur_of_longest_px(view.image, extracted(view.segments)).value_or(0.0);
  return std::max(scale_of_edges(view), static_cast<int>(std::lround(blur_px)));
}

Scene at_scale_of_blur(const Scene& scene, std::span<const int> factors) {
  Scene scaled{{}, scene.height_range_in_local_m, scene.frame};
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    View& view = scaled.views.emplace_back(reduced(scene.views[i], factors[i]));
    if (factors[i] <= scale_of_edges(scene.views[i])) continue;
    for (EdgeSegment& segment : view.segments) add_error_of_blur(segment.line);
  }
  return scaled;
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
