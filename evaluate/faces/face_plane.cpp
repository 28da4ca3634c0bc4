// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_plane.h"

#include "evaluate/faces/limits.h"
#include "evaluate/judge/plane_search.h"
#include "evaluate/probability.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// The consensus uses at most this many points; the fit uses all of them.
constexpr std::size_t kMaxSearchedPoints = 2000;

/// The points that a plane similar to the face's own can hold.
std::vector<ZonePoint> candidates(std::span<const FacePoint> points,
                                  const RoofFace& face,
                                  const JudgeOptions& options) {
  const double slope_rad = ridgeline::slope_rad(face.plane);
  const double tilt_rad = kMaxFaceTilt_deg * kRadPerDeg;
  constexpr double kNearlyUpright_rad = 89.0 * kRadPerDeg;
  const double steeper = std::tan(std::min(slope_rad + tilt_rad, kNearlyUpright_rad));
  // how far a plane of another tilt departs from the face's own, per metre in plan from the
  // centroid
  const double spread =
      std::max(steeper - std::tan(slope_rad), std::tan(slope_rad) - std::tan(slope_rad - tilt_rad));
  const double farthest_m = kMaxFaceHeight_m + options.inlier_distance_m / face.plane.normal().z();
  std::vector<ZonePoint> kept;
  for (const FacePoint& p : points) {
    if (!is_well_inside(p)) continue;
    const Eigen::Vector2d x = p.point.x.head<2>();
    const double height_m = std::abs(p.point.x.z() - height_at(face.plane, x));
    const double distance_m = (x - face.centroid.head<2>()).norm();
    if (height_m <= farthest_m + spread * distance_m) kept.push_back(p.point);
  }
  return kept;
}

std::vector<ZonePoint> thinned(const std::vector<ZonePoint>& points) {
  if (points.size() <= kMaxSearchedPoints) return points;
  std::vector<ZonePoint> kept;
  for (std::size_t i = 0; i < kMaxSearchedPoints; ++i) {
    kept.push_back(points[i * points.size() / kMaxSearchedPoints]);
  }
  return kept;
}

bool is_like(const Plane3& plane, const RoofFace& face) {
  const double cosine = plane.normal().dot(face.plane.normal());
  const double height_m = height_at(plane, face.centroid.head<2>()) - face.centroid.z();
  return cosine >= std::cos(kMaxFaceTilt_deg * kRadPerDeg) &&
         std::abs(height_m) <= kMaxFaceHeight_m;
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

/// Total least squares fit to the points within the limit, repeated until these stay the same.
std::optional<PlaneFit> settled_fit(const std::vector<ZonePoint>& points,
                                    const Plane3& start,
                                    const JudgeOptions& options) {
  constexpr int kMaxPasses = 20;  // usually 3 to 6; two sets may alternate
  const double limit_m = options.inlier_distance_m;
  std::vector<Eigen::Vector3d> inliers = inliers_of(points, start, limit_m);
  std::optional<PlaneFit> fit;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    fit = fit_plane(inliers);
    if (!fit || fit->n < options.min_points) return std::nullopt;
    std::vector<Eigen::Vector3d> next = inliers_of(points, fit->plane, limit_m);
    if (next == inliers) break;
    inliers = std::move(next);
  }
  fit->sigma0_m = untruncated_sigma_m(fit->sigma0_m, limit_m);
  return fit;
}

/// Variance of a standard normal distribution truncated at -k and k.
double variance_cut_off_at(double k) {
  const double density = std::exp(-0.5 * k * k) / std::sqrt(2.0 * std::numbers::pi);
  return 1.0 - 2.0 * k * density / (2.0 * normal_cdf(k) - 1.0);
}

bool may_be_on(const NeighbourFace& other,
               const PlaneFit& fit,
               const FacePoint& point,
               const JudgeOptions& options) {
  return other.fit && is_on(other.fit->plane, point, options) &&
         !are_nearly_one(fit.plane, other.fit->plane) &&
         other.face->plan.distance_m(point.point.x.head<2>()) <= kFaceReach_m;
}

}  // namespace

bool is_well_inside(const FacePoint& point) { return point.beyond_m <= -kBorderGap_m; }

bool is_on(const Plane3& plane, const FacePoint& point, const JudgeOptions& options) {
  return plane.absDistance(point.point.x) <= options.inlier_distance_m;
}

std::optional<PlaneFit> find_face_plane(std::span<const FacePoint> points,
                                        const RoofFace& face,
                                        const JudgeOptions& options,
                                        const PointNormals& normals) {
  const std::vector<ZonePoint> inside = candidates(points, face, options);
  std::optional<PlaneFit> best;
  for (const FoundPlane& found : search_planes(thinned(inside), options, normals)) {
    const std::optional<PlaneFit> fit = settled_fit(inside, found.fit.plane, options);
    if (fit && is_like(fit->plane, face) && (!best || fit->n > best->n)) best = fit;
  }
  return best;
}

PlaneFit refit_face_plane(std::span<const FacePoint> points,
                          const PlaneFit& fit,
                          std::span<const NeighbourFace> neighbours,
                          const JudgeOptions& options) {
  std::vector<ZonePoint> own;
  for (const FacePoint& p : points) {
    const bool shared = std::ranges::any_of(
        neighbours, [&](const NeighbourFace& other) { return may_be_on(other, fit, p, options); });
    if (is_well_inside(p) && !shared) own.push_back(p.point);
  }
  return settled_fit(own, fit.plane, options).value_or(fit);
}

double untruncated_sigma_m(double truncated_m, double limit_m) {
  double low = 1.5, high = 10.0;  // of k
  for (int i = 0; i < 50; ++i) {
    const double k = 0.5 * (low + high);
    const bool too_narrow = std::sqrt(variance_cut_off_at(k)) * limit_m < k * truncated_m;
    (too_narrow ? high : low) = k;
  }
  return truncated_m / variance_cut_off_at(low);
}

bool are_nearly_one(const Plane3& a, const Plane3& b) {
  return a.normal().dot(b.normal()) > std::cos(kMinAngleOfRidge_deg * kRadPerDeg);
}

}  // namespace ridgeline::evaluate
