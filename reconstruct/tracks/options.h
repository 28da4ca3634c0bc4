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
  double seen_share = 0.7;    ///< share of the views that show an edge if it is in their image
  double look_odds = 20.0;    ///< how much more often matches by their look are true than false
  double min_log_odds = 2.0;  ///< of a track against chance
  double min_margin = 3.0;    ///< log of the odds of its depth against all other depths

  static constexpr auto fields() {
    using O = TrackOptions;
    return std::tuple{
        Field{"all_views", &O::all_views, false, true,
              "use all images of a patch; off: the first two alone, as the papers do"},
        Field{"sigma_edge_px", &O::sigma_edge_px, 0.01, 10.0,
              "how far the edges that several views show of one line differ"},
        Field{"seen_share", &O::seen_share, 0.01, 0.99,
              "of the views that show an edge which lies in their image"},
        Field{"look_odds", &O::look_odds, 1.0, 1e6,
              "of a match by its look; 1: geometry alone decides"},
        Field{"min_log_odds", &O::min_log_odds, -100.0, 100.0, "of a track against chance"},
        Field{"min_margin", &O::min_margin, 0.0, 100.0,
              "log of the odds of a track's depth against all other depths"}};
  }
};

}  // namespace ridgeline::reconstruct
