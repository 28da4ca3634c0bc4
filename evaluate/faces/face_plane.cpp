// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_plane.h"

#include "evaluate/judge/plane_search.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// The consensus looks at this many points at most; the fit takes all of them.
constexpr std::size_t kMostSearched = 2000;

/// The points that a plane like the face's own can hold.
std::vector<ZonePoint> candidates(std::span<const FacePoint> points,
                                  const RoofFace& face,
                                  const FaceOptions& options) {
  const double slope_rad = ridgeline::slope_rad(face.plane);
  const double tilt_rad = options.max_tilt_deg * kRadPerDeg;
  // heights of planes that are steeper by the largest tilt and so much less steep, per metre from the centroid in plan
  constexpr double kNearlyUpright_rad = 89.0 * kRadPerDeg;
  const double steeper = std::tan(std::min(slope_rad + tilt_rad, kNearlyUpright_rad));
  const double spread =
      std::max(steeper - std::tan(slope_rad), std::tan(slope_rad) - std::tan(slope_rad - tilt_rad));
  std::vector<ZonePoint> kept;
  for (const FacePoint& p : points) {
    if (!is_well_inside(p, options)) continue;
    const Eigen::Vector2d x = p.point.x.head<2>();
    const double height_m = std::abs(p.point.x.z() - height_at(face.plane, x));
    const double distance_m = (x - face.centroid.head<2>()).norm();
    if (height_m <= options.max_height_m + options.judge.inlier_distance_m + spread * distance_m) {
      kept.push_back(p.point);
    }
  }
  return kept;
}

std::vector<ZonePoint> thinned(const std::vector<ZonePoint>& points) {
  if (points.size() <= kMostSearched) return points;
  std::vector<ZonePoint> kept;
  for (std::size_t i = 0; i < kMostSearched; ++i) {
    kept.push_back(points[i * points.size() / kMostSearched]);
  }
  return kept;
}

bool is_like(const Plane3& plane, const RoofFace& face, const FaceOptions& options) {
  const double cosine = plane.normal().dot(face.plane.normal());
  const double height_m = height_at(plane, face.centroid.head<2>()) - face.centroid.z();
  return cosine >= std::cos(options.max_tilt_deg * kRadPerDeg) &&
         std::abs(height_m) <= options.max_height_m;
}

std::vector<Eigen::Vector3d> inliers_of(const std::vector<ZonePoint>& points,
                                        const Plane3& plane,
                                        double distance_m) {
  std::vector<Eigen::Vector3d> inliers;
  for (const ZonePoint& p : points) {
    if (plane.absDistance(p.x) <= distance_m) inliers.push_back(p.x);
  }
  return inliers;
}

/// The fit to all points, repeated until its inliers stay the same.
std::optional<PlaneFit> settled_fit(const std::vector<ZonePoint>& points,
                                    const Plane3& start,
                                    const FaceOptions& options) {
  constexpr int kMostPasses = 20;  // 3 to 6 as a rule; two sets may take turns
  const double distance_m = options.judge.inlier_distance_m;
  std::vector<Eigen::Vector3d> inliers = inliers_of(points, start, distance_m);
  std::optional<PlaneFit> fit;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    fit = fit_plane(inliers);
    if (!fit || fit->n < options.judge.min_points) return std::nullopt;
    std::vector<Eigen::Vector3d> next = inliers_of(points, fit->plane, distance_m);
    if (next == inliers) break;
    inliers = std::move(next);
  }
  return fit;
}

}  // namespace

bool is_well_inside(const FacePoint& point, const FaceOptions& options) {
  return point.beyond_m <= -options.border_gap_m;
}

bool is_on(const Plane3& plane, const FacePoint& point, const FaceOptions& options) {
  return plane.absDistance(point.point.x) <= options.judge.inlier_distance_m;
}

std::optional<PlaneFit> fit_face_plane(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const FaceOptions& options,
                                       const PointNormals& normals) {
  const std::vector<ZonePoint> inside = candidates(points, face, options);
  const std::uint64_t key = line_key(face.id, options.judge.seed);
  std::optional<PlaneFit> best;
  for (const FoundPlane& found : search_planes(thinned(inside), options.judge, key, normals)) {
    const std::optional<PlaneFit> fit = settled_fit(inside, found.fit.plane, options);
    if (fit && is_like(fit->plane, face, options) && (!best || fit->n > best->n)) best = fit;
  }
  return best;
}

}  // namespace ridgeline::evaluate
