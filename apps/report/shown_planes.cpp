// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/shown_planes.h"

#include "evaluate/judge/options.h"
#include "evaluate/judge/point_grid.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ridgeline::apps {
namespace {

/// The planes of the lines, one for each id, by descending number of inliers.
std::vector<ShownPlane> planes_of(const std::vector<evaluate::LineEvaluation>& lines) {
  std::map<std::uint64_t, ShownPlane> by_id;
  for (const evaluate::LineEvaluation& line : lines) {
    for (const evaluate::JudgingPlane& p : line.planes) {
      const ShownPlane plane{p.id, p.plane, p.n_inliers, p.rms_m, {}};
      const auto [entry, is_new] = by_id.try_emplace(plane.id, plane);
      if (!is_new && plane.n_inliers > entry->second.n_inliers) entry->second = plane;
    }
  }
  std::vector<ShownPlane> planes;
  planes.reserve(by_id.size());
  for (auto& [id, plane] : by_id) planes.push_back(std::move(plane));
  std::stable_sort(planes.begin(), planes.end(), [](const ShownPlane& a, const ShownPlane& b) {
    return a.n_inliers > b.n_inliers;
  });
  constexpr std::size_t kMaxPlanes = std::numeric_limits<std::uint16_t>::max();  // 0 means no plane
  if (planes.size() > kMaxPlanes) planes.resize(kMaxPlanes);
  return planes;
}

/// The convex hull of the plane's points in plan, projected vertically onto the plane.
std::vector<Eigen::Vector3d> outline_of(const Plane3& plane,
                                        const std::vector<Eigen::Vector3d>& points) {
  std::vector<cv::Point2f> in_plan;
  in_plan.reserve(points.size());
  for (const Eigen::Vector3d& x : points) {
    in_plan.emplace_back(static_cast<float>(x.x()), static_cast<float>(x.y()));
  }
  std::vector<Eigen::Vector3d> outline;
  if (in_plan.size() < 3) return outline;
  std::vector<cv::Point2f> hull;
  cv::convexHull(in_plan, hull);
  if (hull.size() < 3) return outline;
  for (const cv::Point2f& p : hull) {
    const Eigen::Vector2d x(p.x, p.y);
    const double height_m = height_at(plane, x);
    if (!std::isfinite(height_m)) return {};  // a vertical plane has no hull in plan
    outline.emplace_back(x.x(), x.y(), height_m);
  }
  return outline;
}

}  // namespace

ShownPlanes shown_planes(const ReportPatch& patch, const ReportMethod& method) {
  const evaluate::JudgeOptions& widths = patch.judge;
  const ShownCloud& points = patch.cloud;
  const std::vector<evaluate::LineEvaluation>& lines = method.evaluation.lines;
  ShownPlanes shown;
  shown.planes = planes_of(lines);
  shown.plane_of_point.assign(points.x_in_local.size(), 0);
  std::map<std::uint64_t, std::uint16_t> index;
  for (std::size_t k = 0; k < shown.planes.size(); ++k) {
    index[shown.planes[k].id] = static_cast<std::uint16_t>(k + 1);
  }
  const auto grid = evaluate::PointGrid::build(points.x_in_local.size(),
                                               [&](std::size_t i) { return points.x_in_local[i]; });
  std::vector<double> nearest_m(points.x_in_local.size(), widths.inlier_distance_m);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<Segment3> judged = method.judged_segment(i);
    if (!judged) continue;
    const Segment2 line = plan(*judged);
    for (const evaluate::JudgingPlane& p : lines[i].planes) {
      const std::uint16_t number = index[p.id];
      grid.visit_near(line, widths.fit_half_width_m, [&](const auto& point) {
        if (distance(line, point.x.template head<2>()) > widths.fit_half_width_m) return;
        const double distance_m = p.plane.absDistance(point.x);
        if (distance_m > nearest_m[point.index]) return;
        nearest_m[point.index] = distance_m;
        shown.plane_of_point[point.index] = number;
      });
    }
  }
  std::vector<std::vector<Eigen::Vector3d>> members(shown.planes.size());
  for (std::size_t i = 0; i < points.x_in_local.size(); ++i) {
    if (shown.plane_of_point[i] == 0) continue;
    members[shown.plane_of_point[i] - 1U].push_back(points.x_in_local[i]);
  }
  for (std::size_t k = 0; k < shown.planes.size(); ++k) {
    shown.planes[k].outline = outline_of(shown.planes[k].plane, members[k]);
  }
  return shown;
}

}  // namespace ridgeline::apps
