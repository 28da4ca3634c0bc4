// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/reduced_view.h"
#include "reconstruct/surface/surface.h"

#include <array>
#include <span>

namespace ridgeline::reconstruct {

/// The views at the scale at which their edges were found. The tolerances of the matching are meant
/// for this scale.
Scene at_scale_of_edges(const Scene& scene);

/// The factor by which a view is reduced to estimate lines, 1 or more: a pixel is then about as
/// large as the blur of its edges. Objects within the blur of an edge shift it, alike in all views
/// or in only one of them, and the sigmas of these errors are stated in pixels.
int scale_of_blur(const View& view);

/// The views reduced by these factors, the scale_of_blur() of each. Where a factor exceeds the
/// scale of the edges, the segments become more uncertain because of objects within the blur.
Scene at_scale_of_blur(const Scene& scene, std::span<const int> factors);

/// A pair at the scale at which the edges of its views were found.
struct ScaledPair {
  std::array<View, 2> views;
  std::array<double, 2> height_range_in_local_m{};

  explicit ScaledPair(const StereoPair& pair_in_files);
  /// Borrows the views.
  [[nodiscard]] StereoPair pair() const {
    return {{&views[0], &views[1]}, height_range_in_local_m};
  }
};

/// Converts the surface of a ScaledPair to the pixels of the files.
void take_to_pixels_of_files(const StereoPair& pair_in_files, Surface& surface);

/// The surface of a pair in the pixels of its views after reduction by their factors. The
/// disparities are shared, not copied.
Surface reduced(const StereoPair& pair_in_files,
                Surface surface,
                const std::array<int, 2>& factors);

}  // namespace ridgeline::reconstruct
