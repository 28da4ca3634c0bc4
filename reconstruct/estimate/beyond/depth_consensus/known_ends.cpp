// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/known_ends.h"

#include "reconstruct/geometry/transformed.h"

namespace ridgeline::reconstruct {
namespace {

constexpr double kNearby_px = 100.0;  // largest distance of an end from the line, in the base image
constexpr double kMaxSigma_m = 0.4;   // largest sigma of the height of a known line

}  // namespace

KnownEnds::KnownEnds(const TrackedLines& lines, std::span<const ReconstructedLine> direct) {
  std::vector<Eigen::Vector3d> ends;  // conditioned
  for (const ReconstructedLine& line : direct) {
    if (line.line_class == LineClass::kAligned || !line.segment_in_local) continue;
    if (*line.direct_sigma_z_m > kMaxSigma_m) continue;
    for (const Eigen::Vector3d& end : {line.segment_in_local->start, line.segment_in_local->end})
      ends.push_back(lines.frames.object.conditioned_from_local(end));
  }
  heights_ = transformed(ends, [](const Eigen::Vector3d& end) { return end.z(); });
  // The position of an end is computed by projection, because the line may end where another
  // segment does.
  for (const ConditionedView& view : lines.frames.views) {
    InImage& in_image = by_view_.emplace_back();
    in_image.ends_px = transformed(ends, [&](const Eigen::Vector3d& end) {
      const Eigen::Vector2d x_px =
          view.image.image_from_conditioned(project(view.image_from_object, end));
      return Segment2{x_px, x_px};
    });
    in_image.index = BoxIndex2(in_image.ends_px);
  }
}

std::vector<double> KnownEnds::heights_near(std::size_t view, const Segment2& seen_px) const {
  const InImage& in_image = by_view_[view];
  std::vector<double> heights;
  for (const std::size_t end : in_image.index.near(seen_px, kNearby_px)) {
    if (distance(seen_px, in_image.ends_px[end].start) <= kNearby_px)
      heights.push_back(heights_[end]);
  }
  return heights;
}

}  // namespace ridgeline::reconstruct
