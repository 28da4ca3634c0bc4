// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/known_ends.h"

namespace ridgeline::reconstruct {
namespace {

constexpr double kNearby_px = 100.0;  // largest distance of an end from the line, in the base image
constexpr double kLargestSigma_m = 0.4;  // largest sigma of the height of a known line

}  // namespace

KnownEnds::KnownEnds(const StereoLines& lines, std::span<const ReconstructedLine> direct) {
  for (const ReconstructedLine& line : direct) {
    if (line.line_class == LineClass::kAligned || !line.segment_in_local) continue;
    if (*line.direct_sigma_z_m > kLargestSigma_m) continue;
    add(lines.stereo, line.segment_in_local->start);
    add(lines.stereo, line.segment_in_local->end);
  }
  index_ = SegmentIndex(ends_px_);
}

std::vector<double> KnownEnds::heights_near(const Segment2& seen_px) const {
  std::vector<double> heights;
  for (const int i : index_.near(seen_px, kNearby_px)) {
    const auto end = static_cast<std::size_t>(i);
    if (distance(seen_px, ends_px_[end].start) <= kNearby_px) heights.push_back(heights_[end]);
  }
  return heights;
}

/// The line may end where the right segment does. So the end's place in the left image is computed by projection.
void KnownEnds::add(const StereoViews& stereo, const Eigen::Vector3d& end_in_local) {
  const Eigen::Vector3d x = stereo.object.conditioned_from_local(end_in_local);
  const Eigen::Vector2d x_px =
      stereo.views[0].image.image_from_conditioned(project(stereo.views[0].image_from_object, x));
  ends_px_.push_back({x_px, x_px});
  heights_.push_back(x.z());
}

}  // namespace ridgeline::reconstruct
