// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The common coverage and base-to-height ratio of two views, at the middle of the height range.
struct CommonPlace {
  /// Share of the pixels of a view that are also visible in the other view; the smaller of both.
  double share = 0.0;
  /// Distance between the cameras divided by their mean difference in height from the place.
  double base_to_height = 0.0;
};

/// @param scene  its views have images
CommonPlace common_place(const Scene& scene, const ViewPair& pair);

/// The pairs of views to be matched: one fewer than there are views, connecting all of them. The
/// first two views are the first pair. Then views are connected one by one: of the pairs of a
/// connected and an unconnected view in which each view shows at least 0.3 of the other, the next
/// one has the base-to-height ratio closest to 0.3, where depths are accurate and surfaces still
/// look similar. A view without such a pair is connected to the view with which it has the most in
/// common, but at least 0.1; otherwise it is left out. The result does not depend on the order of
/// the further views.
/// @param scene  its views have images
/// Throws std::invalid_argument if there are three or more views and the first two do not show a
/// common place.
std::vector<ViewPair> choose_pairs(const Scene& scene);

}  // namespace ridgeline::reconstruct
