// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_normals.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

namespace ridgeline::evaluate {

/// Finds the points near a line for the judge: PointGrid or PclPointSearch. The judge applies its
/// own exact tests and sorts what it keeps by position, so that its results do not depend on the
/// search. Queries are const and may run in several threads at once.
class PointSearch {
 public:
  struct Point {
    Eigen::Vector3d x;    ///< local, m
    std::uint32_t index;  ///< in the input
  };

  virtual ~PointSearch() = default;

  /// Calls `visit(point)` once for every point within `radius_m` of the segment in plan, at any
  /// height, and for some points slightly farther away: the caller applies its own exact test.
  template <typename Visitor>
  void visit_near(const Segment2& segment, double radius_m, Visitor&& visit) const {
    visit_runs_near(segment, radius_m, [&visit](Run run) {
      for (const Point& point : run) visit(point);
    });
  }

  /// Number of points within `radius_m` of `x` in plan, bounds included; points at the same
  /// position count once.
  [[nodiscard]] std::size_t count_within(const Eigen::Vector2d& x, double radius_m) const;

  void set_normals(PointNormals normals) { normals_ = std::move(normals); }
  /// Empty unless they were set.
  [[nodiscard]] const PointNormals& normals() const { return normals_; }

 protected:
  using Run = std::span<const Point>;

  PointSearch() = default;
  PointSearch(const PointSearch&) = default;
  PointSearch(PointSearch&&) = default;
  PointSearch& operator=(const PointSearch&) = default;
  PointSearch& operator=(PointSearch&&) = default;

  /// visit_near() by runs of points that are contiguous in memory: the cost of one call per run is
  /// negligible compared with that of testing its points.
  virtual void visit_runs_near(const Segment2& segment,
                               double radius_m,
                               const std::function<void(Run)>& visit) const = 0;

 private:
  PointNormals normals_;
};

}  // namespace ridgeline::evaluate
