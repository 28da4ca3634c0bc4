// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/views/reduced_view.h"

#include <array>

namespace ridgeline::reconstruct {

/// The views in the pixels in which their edges were found. The tolerances of all steps are made for those.
Scene at_scale_of_edges(const Scene& scene);

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

/// The surface of a pair in the pixels of its ScaledPair. The disparities are shared, not copied.
Surface at_scale_of_edges(const StereoPair& pair_in_files, Surface surface);

}  // namespace ridgeline::reconstruct
