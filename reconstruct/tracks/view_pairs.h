// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/views/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The pairs of views to be matched: one less than there are views, which connect all of them. The first view is
/// the base of the first pair. Of the pairs of a view that is connected and one that is not yet, the next one
/// has the base-to-height ratio nearest to 0.3, where depths are good and surfaces look alike. Two views need to
/// show at least 0.3 of each other; a view for which there is no such pair is left out. The result does not
/// depend on the order of the views but for the first one.
/// @param scene  its views have images
/// Throws std::invalid_argument if no two views show the same place.
std::vector<ViewPair> choose_pairs(const Scene& scene);

}  // namespace ridgeline::reconstruct
