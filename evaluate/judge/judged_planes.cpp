// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judged_planes.h"

#include "evaluate/judge/plan_hull.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {
namespace {

struct Gathered {
  JudgedPlane plane;
  std::vector<Eigen::Vector2d> corners;  ///< of the hulls of all lines
};

JudgedPlane with_outline(Gathered gathered) {
  for (const Eigen::Vector2d& x : convex_hull(std::move(gathered.corners))) {
    gathered.plane.outline.emplace_back(x.x(), x.y(), height_at(gathered.plane.plane, x));
  }
  return std::move(gathered.plane);
}

}  // namespace

std::vector<JudgedPlane> judged_planes(std::span<const JudgedResult> results) {
  std::map<std::uint64_t, Gathered> by_id;
  for (const JudgedResult& result : results) {
    for (std::size_t p = 0; p < result.hulls.size(); ++p) {
      const JudgingPlane& fit = result.evaluation.planes[p];
      Gathered& gathered = by_id[fit.id];
      JudgedPlane& plane = gathered.plane;
      if (fit.n_inliers > plane.n_inliers) {
        plane.plane = fit.plane;
        plane.n_inliers = fit.n_inliers;
        plane.rms_m = fit.rms_m;
      }
      plane.id = fit.id;
      ++plane.n_lines;
      gathered.corners.insert(gathered.corners.end(), result.hulls[p].begin(),
                              result.hulls[p].end());
    }
  }
  std::vector<JudgedPlane> planes;
  planes.reserve(by_id.size());
  for (auto& [id, gathered] : by_id) planes.push_back(with_outline(std::move(gathered)));
  return planes;
}

std::vector<PlanePoint> plane_points(std::span<const JudgedResult> results) {
  std::vector<PlanePoint> points;
  for (const JudgedResult& result : results) {
    for (std::size_t p = 0; p < result.inlier_points.size(); ++p) {
      const JudgingPlane& fit = result.evaluation.planes[p];
      for (const Eigen::Vector3d& x : result.inlier_points[p]) {
        points.push_back({x, fit.id, fit.plane.signedDistance(x)});
      }
    }
  }
  const auto place = [](const PlanePoint& p) { return std::tuple(p.x.x(), p.x.y(), p.x.z()); };
  const auto nearest_first = [&](const PlanePoint& a, const PlanePoint& b) {
    return std::tuple(place(a), std::abs(a.distance_m), a.plane_id) <
           std::tuple(place(b), std::abs(b.distance_m), b.plane_id);
  };
  std::ranges::sort(points, nearest_first);
  const auto same_place = [&](const PlanePoint& a, const PlanePoint& b) {
    return place(a) == place(b);
  };
  points.erase(std::unique(points.begin(), points.end(), same_place), points.end());
  std::ranges::stable_sort(points, {}, &PlanePoint::plane_id);
  return points;
}

}  // namespace ridgeline::evaluate
