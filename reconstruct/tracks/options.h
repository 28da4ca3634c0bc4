// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of tracks_of().
struct TrackOptions {
  bool all_views = true;  ///< off: the first pair of views alone, as in the papers
  /// Sigma of each end of a segment across its line, beside those of the two regression lines:
  /// edges that two views show of one line are not quite the same.
  double sigma_edge_px = 0.3;
  // Not options: a test lowers them.
  double min_log_odds = 2.0;  ///< of a track against chance
  double min_margin = 3.0;    ///< log of the odds of its depth against all other depths

  static constexpr auto fields() {
    using O = TrackOptions;
    return std::tuple{
        Field{"all_views", &O::all_views, false, true,
              "use all images of a patch; off: only the first two, as in the papers"},
        Field{"sigma_edge_px", &O::sigma_edge_px, 0.01, 10.0,
              "sigma of the differences between the edges of one line in several views"}};
  }
};

}  // namespace ridgeline::reconstruct
