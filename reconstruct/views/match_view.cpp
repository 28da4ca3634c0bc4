// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/views/match_view.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/views/image_sampler.h"

namespace ridgeline::reconstruct {

SearchedPair searched(const StereoPair& pair) {
  const auto& [left, right] = pair.views;
  for (const MatchView* view : {&left, &right}) {
    check(view->image.depth() == CV_32F && view->image.channels() <= kMaxBands &&
              view->image.rows >= 2 && view->image.cols >= 2,
          "image: must be CV_32F of 1 to 4 bands and at least 2 x 2 pixels");
  }
  check(left.image.channels() == right.image.channels(),
        "bands of the images = ", left.image.channels(), " and ", right.image.channels(),
        ", must be equal");
  return {
      left, right,
      StereoSearch(left.image_from_local, right.image_from_local, pair.height_range_in_local_m)};
}

std::vector<Segment2> ideal_segments(const MatchView& view) {
  return transformed(view.segments, [](const EdgeSegment& edge) { return edge.line.segment; });
}

}  // namespace ridgeline::reconstruct
