// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_grid.h"
#include "evaluate/scan/borders.h"
#include "evaluate/scan/scan_region.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// What lies beyond a place on the border of a plane, relative to its continuation.
enum class Beyond : std::uint8_t {
  kNothing,  ///< no points: the end of the scan
  kLevel,
  kLower,   ///< by more than half a metre
  kDeep,    ///< more than 1.7 m below the border itself: cars are lower
  kHigher,  ///< by more than half a metre, and nothing lower
};

struct Seen {
  Beyond what = Beyond::kNothing;
  bool is_roof = false;  ///< whether points of a roof lie there
};

/// The points around the borders of planes. Borrows its arguments.
class BorderSurroundings {
 public:
  /// @param region_of  of each point; kNoRegion for some
  /// @param is_roof  of each region; what is written to it later counts
  /// @param only_roofs  see ScanOptions; nothing is then kDeep
  BorderSurroundings(const PointGrid& grid,
                     const std::vector<int>& region_of,
                     const std::vector<bool>& is_roof,
                     bool only_roofs)
      : grid_(grid), region_of_(region_of), is_roof_(is_roof), only_roofs_(only_roofs) {}

  /// What lies outside of a region's border at x, in the direction `out`, both in its plane. Where
  /// nothing lies next to the border, as in the shadow of a building, it looks farther.
  [[nodiscard]] Seen beyond(const ScanRegion& region,
                            const Eigen::Vector2d& x,
                            const Eigen::Vector2d& out) const;

  /// What lies beyond most of a border: kNothing, kLevel, kLower or kHigher.
  [[nodiscard]] Beyond beyond(const ScanRegion& region, const Segment2& border) const;

  /// Visits the points next to a border: `visit(st, above_m, in_region)` with the place along and
  /// outside of it, in the plane, the height above the plane, and whether the point is on a plane.
  template <typename Visitor>
  void visit_outside(const ScanRegion& region,
                     const Segment2& border,
                     double width_m,
                     Visitor&& visit) const;

 private:
  Seen within(const ScanRegion& region,
              const Eigen::Vector2d& x,
              const Eigen::Vector2d& out,
              double reach_m) const;

  const PointGrid& grid_;
  const std::vector<int>& region_of_;
  const std::vector<bool>& is_roof_;
  bool only_roofs_;
};

template <typename Visitor>
void BorderSurroundings::visit_outside(const ScanRegion& region,
                                       const Segment2& border,
                                       double width_m,
                                       Visitor&& visit) const {
  const Eigen::Vector2d u = along(border), out(u.y(), -u.x());
  const Segment2 in_plan{region.in_local(border.start).head<2>(),
                         region.in_local(border.end).head<2>()};
  const double length_m = length(border);
  grid_.visit_near(in_plan, width_m, [&](const PointGrid::Point& p) {
    const double above_m = p.x.z() - height_at(region.fit.plane, p.x.head<2>());
    const Eigen::Vector3d on_plane(p.x.x(), p.x.y(), p.x.z() - above_m);
    const Eigen::Vector2d d = region.in_plane(on_plane) - border.start;
    const Eigen::Vector2d st(u.dot(d), out.dot(d));
    if (st.x() >= 0.0 && st.x() <= length_m && std::abs(st.y()) <= width_m)
      visit(st, above_m, region_of_[p.index] != kNoRegion);
  });
}

}  // namespace ridgeline::evaluate
