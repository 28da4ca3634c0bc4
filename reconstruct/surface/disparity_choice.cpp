// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/disparity_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr float kUnknown = -1.0F;

std::uint16_t least_of(const std::uint16_t* costs, int n) {
  std::uint16_t least = costs[0];
  for (int k = 1; k < n; ++k) least = std::min(least, costs[k]);
  return least;
}

/// Number of costs in [from, to) that are at most `limit`.
int n_up_to(std::uint16_t limit, const std::uint16_t* costs, int from, int to) {
  int n = 0;
  for (int k = from; k < to; ++k) n += costs[k] <= limit ? 1 : 0;
  return n;
}

/// Whether a disparity not adjacent to the best one costs at most a twentieth more.
bool is_ambiguous(const std::uint16_t* costs, int n, int best) {
  constexpr int kUniquenessPercent = 5;
  const int alike = (100 * costs[best] - 1) / (100 - kUniquenessPercent);
  const auto limit =
      static_cast<std::uint16_t>(std::min<int>(alike, std::numeric_limits<std::uint16_t>::max()));
  return n_up_to(limit, costs, 0, n) >
         n_up_to(limit, costs, std::max(best - 1, 0), std::min(best + 2, n));
}

}  // namespace

DisparityChoice::DisparityChoice(const DisparityRanges& ranges) : ranges_(ranges) {}

void DisparityChoice::of_row(int y, const std::uint16_t* costs, float* disparities_px) {
  const int right_width = ranges_.size_px.width + ranges_.n_all;
  best_of_right_.assign(static_cast<std::size_t>(right_width), -1);
  least_of_right_.assign(static_cast<std::size_t>(right_width), std::numeric_limits<int>::max());
  for (int x = 0; x < ranges_.size_px.width; ++x) {
    const DisparityRange& range = ranges_.at(x, y);
    disparities_px[x] = of_pixel(x, range, costs);
    costs += range.n;
  }
  for (int x = 0; x < ranges_.size_px.width; ++x) {
    const float d = disparities_px[x];
    if (d >= 0.0F && contradicts(x, static_cast<int>(std::floor(d))) &&
        contradicts(x, static_cast<int>(std::ceil(d))))
      disparities_px[x] = kUnknown;
  }
}

float DisparityChoice::of_pixel(int x, const DisparityRange& range, const std::uint16_t* costs) {
  if (range.n == 0) return kUnknown;
  const std::uint16_t least = least_of(costs, range.n);
  const auto best = static_cast<int>(std::find(costs, costs + range.n, least) - costs);
  if (is_ambiguous(costs, range.n, best)) return kUnknown;
  const int d = range.first + best;
  const auto in_right = static_cast<std::size_t>(x + ranges_.n_all - d);
  if (least < least_of_right_[in_right]) {
    least_of_right_[in_right] = least;
    best_of_right_[in_right] = d;
  }
  if (best == 0 || best == range.n - 1) {
    const bool is_end_of_all = d == 0 || d == ranges_.n_all - 1;
    return is_end_of_all ? static_cast<float>(d) : kUnknown;
  }
  const int below = costs[best - 1];
  const int above = costs[best + 1];
  const int curvature = std::max(1, below + above - 2 * least);
  return static_cast<float>(d) +
         0.5F * static_cast<float>(below - above) / static_cast<float>(curvature);
}

/// Whether the pixel of the right view at a disparity is matched with a disparity that differs by
/// more than a pixel.
bool DisparityChoice::contradicts(int x, int disparity_px) const {
  const int best = best_of_right_[static_cast<std::size_t>(x + ranges_.n_all - disparity_px)];
  return best >= 0 && std::abs(best - disparity_px) > 1;
}

}  // namespace ridgeline::reconstruct
