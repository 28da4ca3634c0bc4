// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of tracks_of().
struct TrackOptions {
  bool all_views = true;  ///< off: only the first pair of views, as in the papers
  /// Sigma of each end of a segment across its line, in addition to the sigmas of the two
  /// regression lines, because two views do not show exactly the same edge of a line.
  double sigma_edge_px = 0.3;
  // Not options; they are variables so that a test can lower them.
  double min_log_odds = 2.0;  ///< of a track versus chance
  double min_margin = 3.0;    ///< log of the odds of its depth versus all other depths

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
