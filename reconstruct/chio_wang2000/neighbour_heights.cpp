// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/neighbour_heights.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

// Multiple of the sigma of a height difference that is allowed for as noise.
constexpr double kHeightSigmas = 2.0;

/// How far the heights of two lines are apart; negative where they overlap.
double gap_m(const CoreCandidate& a, const CoreCandidate& b) {
  const auto [low_a, high_a] = std::ranges::minmax(a.overlap.height_m);
  const auto [low_b, high_b] = std::ranges::minmax(b.overlap.height_m);
  return std::max(low_a, low_b) - std::min(high_a, high_b);
}

}  // namespace

double NeighbourHeights::height_at(int left,
                                   const CoreCandidate& candidate,
                                   const Eigen::Vector2d& x_px) const {
  return candidate.overlap.height_at(parameter_along(left_segments_[left], x_px));
}

double NeighbourHeights::height_of(const Neighbour& neighbour, const CoreCandidate& mate) const {
  const bool at_junction = noise_ && neighbour.junction_px;
  return at_junction ? height_at(neighbour.left, mate, *neighbour.junction_px)
                     : mate.chain.mean_height_m;
}

bool NeighbourHeights::agree(int left,
                             const CoreCandidate& candidate,
                             const Neighbour& neighbour,
                             const CoreCandidate& mate,
                             double limit_m) const {
  if (!noise_) return std::abs(candidate.chain.mean_height_m - mate.chain.mean_height_m) <= limit_m;
  const double noise_m =
      kHeightSigmas * std::hypot(candidate.chain.height_sigma_m, mate.chain.height_sigma_m);
  const double difference_m = neighbour.junction_px
                                  ? std::abs(height_at(left, candidate, *neighbour.junction_px) -
                                             height_of(neighbour, mate))
                                  : gap_m(candidate, mate);
  return difference_m <= limit_m + noise_m;
}

}  // namespace ridgeline::reconstruct
