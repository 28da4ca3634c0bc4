// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/surface_candidates.h"

#include "reconstruct/surface/side_planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr double kContradicted = 0.1;  // ratio of correct candidates to others
constexpr double kAgreed = 2.7;

/// Standard deviation of the disparity of a line in the rectified views, from its edges only.
double edge_sigma_px(const Segment2& rectified) {
  constexpr double kAcross_px = 0.5;
  constexpr double kMinSine = 0.1;  // the ends of a line along the rows give its disparity
  return kAcross_px / std::max(std::abs(along(rectified).y()), kMinSine);
}

/// Square of the misfit to the side with which a line agrees better, in standard deviations. Empty
/// if a side that is not trusted may explain the line.
std::optional<double> squared_misfit(const SidesOfPiece& piece, double d_px, double edge_sigma_px) {
  constexpr double kMaxOffset = 3.0;
  double best = HUGE_VAL;
  bool knows_both = true;
  for (const auto& plane : piece.planes) {
    if (!plane || !plane->is_trusted()) {
      knows_both = false;
      continue;
    }
    const double sigma_px = std::hypot(plane->sigma_on_line_px(0.0), edge_sigma_px);
    best = std::min(best, std::pow((d_px - plane->on_line(0.0)) / sigma_px, 2.0));
  }
  if (!knows_both && best > kMaxOffset * kMaxOffset) return std::nullopt;
  return best;
}

/// Log odds of a candidate.
/// @param rectified  the left segment, rectified
double log_odds(const Rectification& rectification,
                const Segment2& rectified,
                const std::vector<SidesOfPiece>& pieces,
                const EpipolarOverlap& overlap) {
  // Tolerance at the ends of the overlap, in parameters, because they are uncertain.
  constexpr double kBeside = 0.1;
  double squares = 0.0;
  int n = 0;
  for (const SidesOfPiece& piece : pieces) {
    const double t = piece.middle();
    if (t < overlap.on_left[0] - kBeside || t > overlap.on_left[1] + kBeside) continue;
    const double d_px =
        rectification.disparity_at_height_px(point_at(rectified, t), overlap.height_at(t));
    const auto square = squared_misfit(piece, d_px, edge_sigma_px(rectified));
    if (!square) continue;
    squares += *square;
    ++n;
  }
  if (n == 0) return 0.0;
  return std::log(kContradicted + kAgreed * std::exp(-0.5 * squares / n));
}

}  // namespace

void weigh_by_surface(const Surface& surface,
                      std::span<const Segment2> left,
                      Candidates& candidates) {
  const Rectification& rectification = surface.rectification;
  tbb::parallel_for(std::size_t{0}, left.size(), [&](std::size_t i) {
    if (candidates[i].empty()) return;
    const Segment2 rectified{rectification.rectified(0, left[i].start),
                             rectification.rectified(0, left[i].end)};
    const std::vector<SidesOfPiece> pieces = sides_along(surface, rectified);
    for (Candidate& candidate : candidates[i]) {
      candidate.log_odds += log_odds(rectification, rectified, pieces, candidate.overlap);
    }
  });
}

}  // namespace ridgeline::reconstruct
