// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/neighbourhood.h"

#include "reconstruct/geometry/box_index.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

// Multiple of the sigma of a height difference that is allowed as noise.
constexpr double kHeightSigmas = 2.0;

/// The gap between the height ranges of two lines; negative if they overlap.
double gap_m(const CoreCandidate& a, const CoreCandidate& b) {
  const auto [low_a, high_a] = std::ranges::minmax(a.overlap.height_m);
  const auto [low_b, high_b] = std::ranges::minmax(b.overlap.height_m);
  return std::max(low_a, low_b) - std::min(high_a, high_b);
}

}  // namespace

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
  // A range of 0 would still find segments that cross in the image, whatever their heights.
  if (!(range_m > 0.0)) return neighbourhood;
  const BoxIndex2 index(segments);
  tbb::parallel_for(std::size_t{0}, segments.size(), [&](std::size_t i) {
    if (candidates[i].list.empty()) return;
    const double range_px = range_m / candidates[i].gsd_m;
    const Segment2& s = segments[i];
    for (const std::size_t k : index.near(s, range_px)) {
      if (k == i) continue;
      const double distance_px = distance(s, segments[k]);
      if (distance_px <= range_px)
        neighbourhood[i].push_back({static_cast<int>(k), std::nullopt, distance_px});
    }
    std::ranges::stable_sort(neighbourhood[i], {}, &Neighbour::distance_px);
  });
  return neighbourhood;
}

double NeighbourHeights::height_at(int left,
                                   const CoreCandidate& candidate,
                                   const Eigen::Vector2d& x_px) const {
  return candidate.overlap.height_at(parameter_along(left_segments_[left], x_px));
}

double NeighbourHeights::height_of(const Neighbour& neighbour,
                                   const CoreCandidate& counterpart) const {
  const bool at_junction = noise_ && neighbour.junction_px;
  return at_junction ? height_at(neighbour.left, counterpart, *neighbour.junction_px)
                     : counterpart.chain.mean_height_m;
}

bool NeighbourHeights::agree(int left,
                             const CoreCandidate& candidate,
                             const Neighbour& neighbour,
                             const CoreCandidate& counterpart,
                             double limit_m) const {
  if (!noise_)
    return std::abs(candidate.chain.mean_height_m - counterpart.chain.mean_height_m) <= limit_m;
  const double noise_m =
      kHeightSigmas * std::hypot(candidate.chain.height_sigma_m, counterpart.chain.height_sigma_m);
  const double difference_m = neighbour.junction_px
                                  ? std::abs(height_at(left, candidate, *neighbour.junction_px) -
                                             height_of(neighbour, counterpart))
                                  : gap_m(candidate, counterpart);
  return difference_m <= limit_m + noise_m;
}

}  // namespace ridgeline::reconstruct
