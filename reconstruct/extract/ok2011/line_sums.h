// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace ridgeline::reconstruct {

/// Sums over points (t, q) along and across a line. They allow lines to be fitted to runs of points
/// without visiting the points again.
struct LineSums {
  double n = 0.0, t = 0.0, q = 0.0, tt = 0.0, tq = 0.0, qq = 0.0;

  LineSums& operator+=(const Eigen::Vector2d& x) {
    n += 1.0;
    t += x.x();
    q += x.y();
    tt += x.x() * x.x();
    tq += x.x() * x.y();
    qq += x.y() * x.y();
    return *this;
  }
  LineSums operator+(const LineSums& o) const {
    return {n + o.n, t + o.t, q + o.q, tt + o.tt, tq + o.tq, qq + o.qq};
  }
  LineSums operator-(const LineSums& o) const {
    return {n - o.n, t - o.t, q - o.q, tt - o.tt, tq - o.tq, qq - o.qq};
  }
  /// Sum of the squared residuals of the regression of q on t.
  [[nodiscard]] double residual() const {
    const double var_t = tt - t * t / n;
    const double cov = tq - t * q / n;
    const double var_q = qq - q * q / n;
    return std::max(0.0, var_t > 0.0 ? var_q - cov * cov / var_t : var_q);
  }
};

}  // namespace ridgeline::reconstruct
