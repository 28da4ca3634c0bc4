// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/base_pairs.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

// Ok et al. 2011, section 2, give no numbers; these are ours.
constexpr double kFirstRadius_px = 30.0;
constexpr double kMaxRadius_px = 150.0;
constexpr double kGrowth = 1.5;   // factor of the radius per step
constexpr int kMinPartners = 3;   // the radius grows until a segment has this many
constexpr int kMaxPartners = 15;  // the nearest are kept

struct Partner {
  double reach_px;  ///< smallest radius at which the pair is admitted
  int segment;
};

/// The partners of a segment within a radius, nearest first.
std::vector<Partner> partners_within(double radius_px,
                                     std::size_t segment,
                                     std::span<const Segment2> segments,
                                     const BoxIndex2& index) {
  const Segment2& own = segments[segment];
  std::vector<Partner> partners;
  for (const std::size_t other : index.near(own, radius_px)) {
    if (other == segment) continue;
    const Segment2& counterpart = segments[other];
    if (distance(own, counterpart) > radius_px) continue;
    const std::optional<Eigen::Vector2d> x =
        intersection(own, counterpart, kMinPairAngle_deg * kRadPerDeg);
    if (!x) continue;
    const double reach_px = std::max(distance(own, *x), distance(counterpart, *x));
    if (reach_px <= radius_px) partners.push_back({reach_px, static_cast<int>(other)});
  }
  std::ranges::sort(partners, {},
                    [](const Partner& p) { return std::pair(p.reach_px, p.segment); });
  return partners;
}

std::vector<Partner> partners_of(std::size_t segment,
                                 std::span<const Segment2> segments,
                                 const BoxIndex2& index) {
  double radius_px = kFirstRadius_px;
  while (true) {
    std::vector<Partner> partners = partners_within(radius_px, segment, segments, index);
    if (static_cast<int>(partners.size()) >= kMinPartners || radius_px >= kMaxRadius_px) {
      if (static_cast<int>(partners.size()) > kMaxPartners) partners.resize(kMaxPartners);
      return partners;
    }
    radius_px = std::min(kGrowth * radius_px, kMaxRadius_px);
  }
}

}  // namespace

std::vector<BasePair> base_pairs(std::span<const Segment2> segments) {
  const BoxIndex2 index(segments);
  std::vector<std::vector<Partner>> partners(segments.size());
  tbb::parallel_for(std::size_t{0}, segments.size(),
                    [&](std::size_t i) { partners[i] = partners_of(i, segments, index); });
  std::vector<BasePair> pairs;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Partner& partner : partners[i]) {
      const auto [first, second] = std::minmax({static_cast<int>(i), partner.segment});
      pairs.push_back({first, second});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace ridgeline::reconstruct
