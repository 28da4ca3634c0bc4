// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/own_segments.h"

#include "reconstruct/appearance/flanks.h"
#include "reconstruct/extract/edges_of_no_data.h"

#include <optional>

namespace ridgeline::reconstruct {
namespace {

/// The segment in ideal pixels; std::nullopt if an end has none.
std::optional<Segment2> ideal(const View& view, const Segment2& in_image) {
  if (!view.ideal_from_image) return in_image;
  const std::optional<Eigen::Vector2d> start = view.ideal_from_image(in_image.start);
  const std::optional<Eigen::Vector2d> end = view.ideal_from_image(in_image.end);
  if (!start || !end) return std::nullopt;
  return Segment2{*start, *end};
}

}  // namespace

std::vector<EdgeSegment> completed_own_segments(const View& view) {
  std::vector<EdgeSegment> segments;
  for (EdgeSegment segment : view.own_segments.value()) {
    const std::optional<Segment2> line = ideal(view, segment.in_image);
    if (!line) continue;
    segment.line.segment = *line;
    segment.line.centroid_px = midpoint(*line);
    set_flanks(view.image, segment);
    segments.push_back(segment);
  }
  remove_edges_of_no_data(segments, far_from_no_data(view.is_valid));
  return segments;
}

}  // namespace ridgeline::reconstruct
