// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/surroundings.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {

Seen BorderSurroundings::within(const ScanRegion& region,
                                const Eigen::Vector2d& x,
                                const Eigen::Vector2d& out,
                                double reach_m) const {
  constexpr double kGap_m = 0.3, kHalfWidth_m = 0.75, kStep_m = 0.5, kDeep_m = 1.7;
  const Eigen::Vector2d from = region.in_local(x + kGap_m * out).head<2>();
  const Eigen::Vector2d to = region.in_local(x + reach_m * out).head<2>();
  const Eigen::Vector2d u = (to - from).normalized();
  const double length_m = (to - from).norm();
  // coarse borders lie up to a cell too far out, where the plane of a roof is lower
  constexpr double kInside_m = 0.5;
  const double border_z = region.in_local(x - kInside_m * out).z();
  double lowest_m = HUGE_VAL, highest_m = -HUGE_VAL, lowest_z = HUGE_VAL;
  Seen seen;
  grid_.visit_near({from, to}, kHalfWidth_m, [&](const PointGrid::Point& p) {
    const Eigen::Vector2d d = p.x.head<2>() - from;
    const double s = u.dot(d), t = u.x() * d.y() - u.y() * d.x();
    if (s < 0.0 || s > length_m || std::abs(t) > kHalfWidth_m) return;
    const double above_m = p.x.z() - height_at(region.fit.plane, p.x.head<2>());
    lowest_m = std::min(lowest_m, above_m);
    highest_m = std::max(highest_m, above_m);
    lowest_z = std::min(lowest_z, p.x.z());
    const int r = region_of_[p.index];
    if (r != kNoRegion && is_roof_[static_cast<std::size_t>(r)]) seen.is_roof = true;
  });
  if (lowest_m == HUGE_VAL) return seen;
  seen.what = lowest_z < border_z - kDeep_m ? Beyond::kDeep
              : lowest_m < -kStep_m         ? Beyond::kLower
              : highest_m > kStep_m         ? Beyond::kHigher
                                            : Beyond::kLevel;
  return seen;
}

Seen BorderSurroundings::beyond(const ScanRegion& region,
                                const Eigen::Vector2d& x,
                                const Eigen::Vector2d& out) const {
  constexpr double kNear_m = 1.5, kFar_m = 6.0;
  const Seen near = within(region, x, out, kNear_m);
  if (near.what != Beyond::kNothing) return near;
  Seen far = within(region, x, out, kFar_m);
  if (far.what == Beyond::kNothing && only_roofs_) far.what = Beyond::kDeep;
  return far;
}

Beyond BorderSurroundings::beyond(const ScanRegion& region, const Segment2& border) const {
  constexpr double kStep_m = 0.7;
  const int n = static_cast<int>(std::ceil(length(border) / kStep_m));
  const Eigen::Vector2d u = along(border), out(u.y(), -u.x());
  int n_seen = 0, n_lower = 0, n_higher = 0;
  for (int i = 0; i < n; ++i) {
    const Beyond what = beyond(region, point_at(border, (i + 0.5) / n), out).what;
    n_seen += what != Beyond::kNothing ? 1 : 0;
    n_lower += what == Beyond::kLower || what == Beyond::kDeep ? 1 : 0;
    n_higher += what == Beyond::kHigher ? 1 : 0;
  }
  if (n_seen == 0) return Beyond::kNothing;
  if (2 * n_lower >= n_seen) return Beyond::kLower;
  return 2 * n_higher >= n_seen ? Beyond::kHigher : Beyond::kLevel;
}

}  // namespace ridgeline::evaluate
