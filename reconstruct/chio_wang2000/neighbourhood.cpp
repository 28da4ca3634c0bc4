// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/neighbourhood.h"

#include "reconstruct/geometry/segment_index.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace ridgeline::reconstruct {

Neighbourhood adjacent_segments(std::span<const Segment2> segments,
                                std::span<const Structure> structures) {
  Neighbourhood neighbourhood(segments.size());
  for (const Structure& structure : structures) {
    for (const int i : structure.members) {
      for (const int k : structure.members) {
        if (i != k) neighbourhood[i].push_back({k, structure.junction_px, 0.0});
      }
    }
  }
  return neighbourhood;
}

Neighbourhood segments_in_range(std::span<const Segment2> segments,
                                std::span<const CoreCandidates> candidates,
                                double range_m) {
  Neighbourhood neighbourhood(segments.size());
  // A range of 0 would still find segments that cross in the image, whatever their heights are.
  if (!(range_m > 0.0)) return neighbourhood;
  const SegmentIndex index(segments);
  tbb::parallel_for(std::size_t{0}, segments.size(), [&](std::size_t i) {
    if (candidates[i].list.empty()) return;
    const double range_px = range_m / candidates[i].gsd_m;
    const Segment2& s = segments[i];
    for (const int k : index.near(s, range_px)) {
      if (k == static_cast<int>(i)) continue;
      const double distance_px = distance(s, segments[k]);
      if (distance_px <= range_px) neighbourhood[i].push_back({k, std::nullopt, distance_px});
    }
    std::ranges::stable_sort(neighbourhood[i], {}, &Neighbour::distance_px);
  });
  return neighbourhood;
}

}  // namespace ridgeline::reconstruct
