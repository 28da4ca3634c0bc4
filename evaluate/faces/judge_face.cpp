// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/judge_face.h"

#include "evaluate/faces/covered_share.h"
#include "evaluate/faces/face_plane.h"
#include "evaluate/faces/limits.h"
#include "evaluate/faces/outline.h"
#include "evaluate/faces/overhang.h"
#include "evaluate/faces/plane_difference.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::evaluate {
namespace {

/// Why a face cannot be judged, whatever the cloud contains; `evaluated` if it can.
FaceStatus status_of(const RoofFace& face, const JudgeOptions& options) {
  if (face.degenerate) return FaceStatus::kDegenerate;
  const double slope_deg = slope_rad(face.plane) / kRadPerDeg;
  if (slope_deg > options.max_slope_deg || is_upright(face)) return FaceStatus::kSteep;
  return face.plan.area_m2() < kMinFaceArea_m2 ? FaceStatus::kTooSmall : FaceStatus::kEvaluated;
}

int count(std::span<const FacePoint> points, auto&& is_counted) {
  return static_cast<int>(std::ranges::count_if(points, is_counted));
}

double share_on(const Plane3& plane,
                std::span<const FacePoint> points,
                const JudgeOptions& options) {
  const auto inside = [&](const FacePoint& p) { return is_well_inside(p); };
  const int n_on =
      count(points, [&](const FacePoint& p) { return inside(p) && is_on(plane, p, options); });
  return static_cast<double>(n_on) / std::max(1, count(points, inside));
}

/// The radius of a circle that contains eight points on average.
double cover_radius_m(double points_per_m2) {
  return std::sqrt(8.0 / (std::numbers::pi * points_per_m2));
}

/// The points over a face that lie on its plane, in plan.
std::vector<Eigen::Vector2d> points_on(const Plane3& plane,
                                       std::span<const FacePoint> points,
                                       const JudgeOptions& options) {
  std::vector<Eigen::Vector2d> on_plane;
  for (const FacePoint& p : points) {
    const bool over = p.beyond_m <= 0.0;
    if (over && is_on(plane, p, options)) on_plane.emplace_back(p.point.x.head<2>());
  }
  return on_plane;
}

/// Points on the wall below an edge, and points hit by rays that pass the edge, are neither missing
/// nor unexplained, unless the edge is too far out.
void set_areas(std::span<const FacePoint> points,
               std::span<const PlacedPoint> places,
               const RoofFace& face,
               std::span<const NeighbourFace> neighbours,
               FaceEvaluation& evaluation) {
  const auto is_over_roof = [&](const Eigen::Vector2d& x) {
    return face.plan.contains(x) ||
           std::ranges::any_of(neighbours, [&](const NeighbourFace& other) {
             return other.face->plan.contains(x);
           });
  };
  const double deepest_m = 2.0 * kFaceReach_m / kMaxRayTangent;  // limit of the known neighbours
  const auto is_below_edge = [&](const FacePoint& p) {
    const auto edge = std::ranges::find(evaluation.edges, p.edge, &EdgeOffset::edge);
    if (edge != evaluation.edges.end() && edge->offset_m > 0.0 && is_off(*edge)) return false;
    const Eigen::Vector2d x = p.point.x.head<2>();
    const double below_m = height_at(evaluation.fit.plane, x) - p.point.x.z();
    const bool is_on_wall = below_m > 0.0 && p.beyond_m >= -kBorderGap_m;
    return is_on_wall || is_under_overhang(x, std::min(below_m, deepest_m), is_over_roof);
  };
  int n_beyond = 0, n_missing = 0, n_unexplained = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointPlace place = places[i].place;
    if (points[i].beyond_m > 0.0) {
      if (place == PointPlace::kOnFace) ++n_beyond;
      continue;
    }
    const bool is_off_roof = place == PointPlace::kElsewhere || !places[i].explained;
    if (is_off_roof && is_below_edge(points[i])) continue;
    if (place == PointPlace::kElsewhere || place == PointPlace::kAbove) ++n_missing;
    if (!places[i].explained) ++n_unexplained;
  }
  const double m2_per_point = evaluation.plan_area_m2 / evaluation.n_over;
  evaluation.beyond_m2 = n_beyond * m2_per_point;
  evaluation.missing_m2 = n_missing * m2_per_point;
  evaluation.n_unexplained = n_unexplained;
}

}  // namespace

FaceEvaluation find_plane(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options) {
  FaceEvaluation evaluation;
  evaluation.id = face.id;
  evaluation.area_m2 = face.area_m2;
  evaluation.plan_area_m2 = face.plan.area_m2();
  evaluation.status = status_of(face, options);
  if (evaluation.status != FaceStatus::kEvaluated) return evaluation;
  const std::vector<FacePoint> points = points_around(search, face, 0.0);
  evaluation.n_over = static_cast<int>(points.size());
  evaluation.n_unexplained = evaluation.n_over;
  const int n_inside = count(points, [&](const FacePoint& p) { return is_well_inside(p); });
  if (n_inside < options.min_points) {
    const bool none_anywhere = evaluation.n_over < options.min_points;
    evaluation.status = none_anywhere ? FaceStatus::kNoLidar : FaceStatus::kTooSmall;
    return evaluation;
  }
  const std::optional<PlaneFit> fit = find_face_plane(points, face, options, search.normals());
  if (!fit || share_on(fit->plane, points, options) < kMinShareOnPlane) {
    evaluation.status = FaceStatus::kNoPlane;
    return evaluation;
  }
  evaluation.fit = *fit;
  return evaluation;
}

void refine_plane(const PointSearch& search,
                  const RoofFace& face,
                  std::span<const NeighbourFace> neighbours,
                  const JudgeOptions& options,
                  FaceEvaluation& evaluation) {
  if (evaluation.status != FaceStatus::kEvaluated) return;
  const std::vector<FacePoint> points = points_around(search, face, 0.0);
  evaluation.fit = refit_face_plane(points, evaluation.fit, neighbours, options);
  evaluation.difference = difference_of(face, evaluation.fit);
  evaluation.share_on_plane = share_on(evaluation.fit.plane, points, options);
}

void judge_outline(const PointSearch& search,
                   const RoofFace& face,
                   std::span<const NeighbourFace> neighbours,
                   const JudgeOptions& options,
                   FaceEvaluation& evaluation) {
  if (evaluation.status != FaceStatus::kEvaluated) return;
  const std::vector<FacePoint> points = points_around(search, face, kFaceReach_m);
  const std::vector<PlacedPoint> places =
      placed_points(points, face, evaluation.fit, neighbours, options);
  const std::vector<Eigen::Vector2d> on_plane = points_on(evaluation.fit.plane, points, options);
  const double over_per_m2 = evaluation.n_over / evaluation.plan_area_m2;
  evaluation.covered_share = covered_share(face.plan, on_plane, cover_radius_m(over_per_m2));
  const double on_per_m2 = static_cast<double>(on_plane.size()) / evaluation.plan_area_m2;
  evaluation.edges = edge_offsets(points, places, face, on_per_m2);
  set_areas(points, places, face, neighbours, evaluation);
  evaluation.verdict = plane_verdict(face, evaluation.fit, evaluation.difference);
  evaluation.verdict.outline = is_outline_wrong(evaluation.edges);
}

FaceEvaluation judge_face(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options) {
  FaceEvaluation evaluation = find_plane(search, face, options);
  refine_plane(search, face, {}, options, evaluation);
  judge_outline(search, face, {}, options, evaluation);
  return evaluation;
}

}  // namespace ridgeline::evaluate
