// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/reduced_view.h"
#include "reconstruct/surface/surface.h"

#include <array>
#include <span>

namespace ridgeline::reconstruct {

/// The views in the pixels in which their edges were found. The tolerances of matching are made for
/// those.
Scene at_scale_of_edges(const Scene& scene);

/// The factor by which a view is reduced to estimate lines, 1 or more: a pixel is then about as
/// large as the blur of its edges. What lies within the blur of an edge moves it, in all views
/// alike or in one of them, and the sigmas of these errors are stated in pixels.
int scale_of_blur(const View& view);

/// The views reduced by these factors, scale_of_blur() of each. Where that is more than the scale
/// of the edges, what lies within the blur adds to the uncertainty of the segments.
Scene at_scale_of_blur(const Scene& scene, std::span<const int> factors);

/// A pair in the pixels in which the edges of its views were found.
struct ScaledPair {
  std::array<View, 2> views;
  std::array<double, 2> height_range_in_local_m{};

  explicit ScaledPair(const StereoPair& pair_in_files);
  /// Borrows the views.
  [[nodiscard]] StereoPair pair() const {
    return {{&views[0], &views[1]}, height_range_in_local_m};
  }
};

/// Takes the surface of a ScaledPair to the pixels of the files.
void take_to_pixels_of_files(const StereoPair& pair_in_files, Surface& surface);

/// The surface of a pair in the pixels of its views reduced by their factors. The disparities are
/// shared, not copied.
Surface reduced(const StereoPair& pair_in_files,
                Surface surface,
                const std::array<int, 2>& factors);

}  // namespace ridgeline::reconstruct
