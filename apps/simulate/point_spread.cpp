// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/point_spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ridgeline::simulate {
namespace {

/// The smallest squared distance between two points of the periodic lattice (i, i * step mod n).
int spacing(int n, int step) {
  int nearest = 2 * n * n;
  for (int i = 1; i < n; ++i) {
    const int row = i * step % n;
    const int dx = std::min(i, n - i);
    const int dy = std::min(row, n - row);
    nearest = std::min(nearest, dx * dx + dy * dy);
  }
  return nearest;
}

/// The step whose lattice has the largest spacing().
int best_step(int n) {
  int best = 1;
  for (int step = 1; step < n; ++step) {
    if (std::gcd(step, n) == 1 && spacing(n, step) > spacing(n, best)) best = step;
  }
  return best;
}

}  // namespace

SubPixelLattice::SubPixelLattice(int samples_per_side) {
  const int n = samples_per_side * samples_per_side;
  const int step = best_step(n);
  for (int i = 0; i < n; ++i) {
    positions.push_back({kSubPixels * i / n, kSubPixels * (i * step % n) / n});
  }
}

PointSpread::PointSpread(double sigma_px) {
  for (int s = 0; s < kSubPixels; ++s) {
    const double offset = (s + 0.5) / kSubPixels - 0.5;  // from the pixel's centre
    for (int k = -kReachPx; k <= kReachPx; ++k) {
      const double z = (offset - k) / sigma_px;
      const int tap = k + kReachPx;
      table_[static_cast<std::size_t>(s)][static_cast<std::size_t>(tap)] =
          static_cast<float>(std::exp(-0.5 * z * z));
    }
  }
}

}  // namespace ridgeline::simulate
