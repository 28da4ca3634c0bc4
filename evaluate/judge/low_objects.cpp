// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/low_objects.h"

#include "evaluate/judge/image_evidence.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

/// Whether the object is like a car parked beside a marking or a box on a terrace: a small level surface
/// less than 2 m above a larger level one, the base, that lies on both sides of the line.
bool is_low_object(const CandidatePlane& object,
                   const CandidatePlane& base,
                   double spacing_m,
                   const JudgeOptions& options) {
  constexpr double kLevel_rad = 0.17;  // 10 degrees
  constexpr double kHighest_m = 2.0;
  constexpr double kLargest_m2 = 15.0;  // two cars; roofs with less are dormers, on slopes
  constexpr double kNarrow = 6.0;       // length / width; a longer object is a parapet, and stays
  constexpr double kOtherSide = 0.1;
  constexpr double kLarger = 2.0;  // the bonnet of a car is no street
  const auto n = static_cast<double>(object.inliers.size());
  const auto n_base = static_cast<double>(base.inliers.size());
  const double area_m2 = n * spacing_m * spacing_m;
  if (n_base * spacing_m * spacing_m <= kLargest_m2 && n_base < kLarger * n) return false;
  const double elongation = std::sqrt(object.fit.spread_m2.x() / object.fit.spread_m2.y());
  const double above_m = base.fit.plane.signedDistance(object.fit.centroid);
  if (slope_rad(base.fit.plane) > kLevel_rad || slope_rad(object.fit.plane) > kLevel_rad ||
      area_m2 > kLargest_m2 || elongation > kNarrow || above_m < 0.0 || above_m > kHighest_m) {
    return false;
  }
  std::size_t left = 0;
  std::size_t right = 0;
  for (const ZonePoint& p : base.inliers) {
    if (std::abs(p.t) > options.corridor_half_width_m) continue;
    ++(p.t > 0.0 ? left : right);
  }
  return static_cast<double>(std::min(left, right)) >=
         kOtherSide * static_cast<double>(std::max(left, right));
}

bool images_prefer(const CandidatePlane& object,
                   const CandidatePlane& base,
                   const std::optional<ImageEvidence>& images) {
  return images &&
         image_cost(*images, base.fit.plane) - image_cost(*images, object.fit.plane) > kImageMargin;
}

}  // namespace

void mark_low_objects(std::vector<CandidatePlane>& candidates,
                      double spacing_m,
                      const std::optional<ImageEvidence>& images,
                      const JudgeOptions& options) {
  for (CandidatePlane& plane : candidates) {
    plane.low_object = std::any_of(candidates.begin(), candidates.end(), [&](const auto& base) {
      return &base != &plane && is_low_object(plane, base, spacing_m, options) &&
             !images_prefer(plane, base, images);
    });
  }
}

}  // namespace ridgeline::evaluate
