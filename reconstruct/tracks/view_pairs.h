// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// How two views show one place, at the middle of the heights.
struct CommonPlace {
  double share =
      0.0;  ///< of the pixels of either view that the other one shows, the smaller of both
  double base_to_height =
      0.0;  ///< distance of the cameras over their mean distance to the place in height
};

/// @param scene  its views have images
CommonPlace common_place(const Scene& scene, const ViewPair& pair);

/// The pairs of views to be matched: one less than there are views, which connect all of them. The
/// first two views are the first pair. Of the pairs of a view that is connected and one that is not
/// yet, the next one has the base-to-height ratio nearest to 0.3, where depths are good and
/// surfaces look alike, if both views show at least 0.3 of each other. A view for which there is no
/// such pair is connected to the one with which it shows the most in common, at least 0.1; else it
/// is left out. The result does not depend on the order of the further views.
/// @param scene  its views have images
/// Throws std::invalid_argument if the first two of three views and more do not show the same
/// place.
std::vector<ViewPair> choose_pairs(const Scene& scene);

}  // namespace ridgeline::reconstruct
