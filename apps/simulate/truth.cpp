// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/truth.h"

#include "apps/simulate/ray_scene.h"
#include "reconstruct/geometry/check.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::simulate {
namespace {

constexpr double kCorridorM = 1.5;
constexpr double kOnPlaneM = 0.15;  // more than four standard deviations of the default noise

/// Points by square cells of the plan, so that those in a corridor are found without testing all of
/// them.
class ReturnGrid {
 public:
  ReturnGrid(const std::vector<io::CloudPoint>& points, const Eigen::Vector2d& extent_m)
      : points_(points),
        columns_(1 + static_cast<int>(extent_m.x() / kCellM)),
        rows_(1 + static_cast<int>(extent_m.y() / kCellM)),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      cells_[cell(column(points[i].x), row(points[i].y))].push_back(i);
    }
  }

  template <typename Visit>
  void visit_near(const Segment2& segment, double radius_m, const Visit& visit) const {
    const Eigen::Vector2d low = segment.start.cwiseMin(segment.end).array() - radius_m;
    const Eigen::Vector2d high = segment.start.cwiseMax(segment.end).array() + radius_m;
    for (int r = row(low.y()); r <= row(high.y()); ++r) {
      for (int c = column(low.x()); c <= column(high.x()); ++c) {
        for (const std::size_t i : cells_[cell(c, r)]) {
          const io::CloudPoint& p = points_[i];
          if (distance(segment, Eigen::Vector2d(p.x, p.y)) <= radius_m) visit(p);
        }
      }
    }
  }

 private:
  static constexpr double kCellM = 2.0;
  [[nodiscard]] int column(double x) const {
    return std::clamp(static_cast<int>(x / kCellM), 0, columns_ - 1);
  }
  [[nodiscard]] int row(double y) const {
    return std::clamp(static_cast<int>(y / kCellM), 0, rows_ - 1);
  }
  [[nodiscard]] std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  const std::vector<io::CloudPoint>& points_;
  int columns_, rows_;
  std::vector<std::vector<std::size_t>> cells_;
};

double visible_share(const RayScene& rays, const Segment3& segment) {
  constexpr double kStepM = 0.25;
  constexpr double kLiftM = 0.01;  // lifts rays off the surfaces adjacent to the line
  const int samples = 1 + static_cast<int>(length(segment) / kStepM);
  int visible = 0;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector3d x = point_at(segment, (i + 0.5) / samples);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    visible += rays.first_hit(x + kLiftM * up, up) ? 0 : 1;
  }
  return static_cast<double>(visible) / samples;
}

int returns_on(const ScenePlane& plane, const Segment3& line, const ReturnGrid& grid) {
  ConvexPolygon outline;
  for (const Eigen::Vector3d& corner : plane.outline) outline.emplace_back(corner.head<2>());
  int count = 0;
  grid.visit_near(plan(line), kCorridorM, [&](const io::CloudPoint& p) {
    const bool on =
        std::abs(plane.plane.signedDistance(Eigen::Vector3d(p.x, p.y, p.z))) <= kOnPlaneM;
    if (on && contains(outline, {p.x, p.y})) ++count;
  });
  return count;
}

}  // namespace

std::vector<TruthLine> observe_lines(const SyntheticScene& scene, const io::PointCloud& cloud) {
  check(cloud.frame.origin_m == scene.frame.origin_m,
        "observe_lines: cloud.frame.origin_m = ", cloud.frame.origin_m.transpose(),
        ", must be that of the scene, ", scene.frame.origin_m.transpose());
  const RayScene rays(scene.mesh);
  const ReturnGrid grid(cloud.points, scene.extent_m);
  std::vector<TruthLine> result(scene.lines.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, result.size()), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const SceneLine& line = scene.lines[i];
      result[i].id = static_cast<int>(i);
      result[i].visible_share = visible_share(rays, line.segment);
      for (const int id : line.plane_ids) {
        const ScenePlane& plane = scene.planes[static_cast<std::size_t>(id)];
        result[i].plane_returns.push_back(returns_on(plane, line.segment, grid));
      }
    }
  });
  return result;
}

}  // namespace ridgeline::simulate
