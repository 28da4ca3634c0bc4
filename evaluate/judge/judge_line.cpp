// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judge_line.h"

#include "evaluate/judge/candidate_planes.h"
#include "evaluate/judge/footprint.h"
#include "evaluate/judge/image_evidence.h"
#include "evaluate/judge/plan_hull.h"
#include "evaluate/judge/plane_meeting.h"
#include "evaluate/judge/plane_sigma.h"
#include "evaluate/judge/ridge_displacement.h"
#include "evaluate/judge/surface_decision.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <sstream>

namespace ridgeline::evaluate {
namespace {

constexpr double kMinLength_m = 0.3;  ///< shorter lines are `too_short` (calibration.md)

template <typename... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

std::size_t count_in_corridor(std::span<const ZonePoint> zone,
                              const Footprint& footprint,
                              const JudgeOptions& options) {
  return static_cast<std::size_t>(std::count_if(zone.begin(), zone.end(), [&](const ZonePoint& p) {
    return std::abs(p.t) <= options.corridor_half_width_m && p.s >= -options.corridor_end_m &&
           p.s <= footprint.length_m + options.corridor_end_m;
  }));
}

/// How far a line lies above (positive) or below all points, m; 0 between them.
double height_off_m(std::span<const ZonePoint> zone, const Segment3& segment) {
  const auto by_height = [](const ZonePoint& p) { return p.x.z(); };
  const auto [lowest, highest] = std::ranges::minmax_element(zone, {}, by_height);
  const auto [low, high] = std::minmax({segment.start.z(), segment.end.z()});
  return std::max(0.0, low - highest->x.z()) + std::min(0.0, high - lowest->x.z());
}

bool marks_missing_height(double height_off_m, const Segment3& segment) {
  return segment.start.z() == segment.end.z() && std::abs(height_off_m) > kMaxHeightOffset_m;
}

JudgingPlane judging_plane(const CandidatePlane& candidate,
                           const Footprint& footprint,
                           const Segment3& segment) {
  return {.plane = candidate.fit.plane,
          .n_inliers = candidate.fit.n,
          .rms_m = candidate.fit.rms_m,
          .coverage = candidate.coverage,
          .extrapolation_m = extrapolation_beyond(candidate.inliers, footprint),
          .sigma_m = plane_sigma_m(candidate.fit, candidate.inliers, midpoint(segment)),
          .sigma_random_m = candidate.fit.sigma_at(midpoint(segment)),
          .distance = orthogonal_distance(segment, candidate.fit.plane)};
}

/// Standard deviation of the line's midpoint along `direction` from the covariance of its ends.
double sigma_at_midpoint(const Eigen::Matrix<double, 6, 6>& cov, const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 6, 1> jacobian;
  jacobian << 0.5 * direction, 0.5 * direction;
  return std::sqrt(std::max(0.0, jacobian.dot(cov * jacobian)));
}

/// Averages the distances over the chosen planes and predicts their standard deviations.
void summarise(LineEvaluation& e, const JudgedLine& line) {
  const auto n = static_cast<double>(e.planes.size());
  Eigen::Vector3d mean_normal = Eigen::Vector3d::Zero();
  double mean_distance_m = 0.0, max_distance_m = 0.0, signed_mean_m = 0.0, variance = 0.0;
  for (const JudgingPlane& p : e.planes) {
    mean_distance_m += p.distance.mean_abs / n;
    signed_mean_m += p.distance.mean / n;
    max_distance_m = std::max(max_distance_m, p.distance.max_abs);
    mean_normal += p.plane.normal() / n;
    variance += p.sigma_m * p.sigma_m / (n * n);
  }
  e.mean_distance_m = mean_distance_m;
  e.max_distance_m = max_distance_m;
  e.signed_mean_m = signed_mean_m;
  e.sigma_plane_m = std::sqrt(variance);
  if (!line.covariance_m2) return;
  e.sigma_line_m = sigma_at_midpoint(*line.covariance_m2, mean_normal);
  const double sigma = std::hypot(*e.sigma_line_m, *e.sigma_plane_m);
  if (sigma > 0.0) e.z = signed_mean_m / sigma;
}

/// Distance of the midpoint from the intersection line of a ridge's planes, and the angle between
/// the line and that intersection.
void compare_with_intersection(LineEvaluation& e, const Segment3& segment) {
  const Eigen::Vector3d n1 = e.planes[0].plane.normal();
  const Eigen::Vector3d n2 = e.planes[1].plane.normal();
  const Eigen::Vector3d direction = n1.cross(n2).normalized();
  const Eigen::Vector3d x = midpoint(segment);
  // to_line leads from x to a point on both planes, perpendicular to the intersection line
  Eigen::Matrix3d a;
  a << n1.transpose(), n2.transpose(), direction.transpose();
  const Eigen::Vector3d to_line =
      a.inverse() * Eigen::Vector3d(-e.planes[0].plane.signedDistance(x),
                                    -e.planes[1].plane.signedDistance(x), 0.0);
  e.intersection_distance_m = to_line.norm();
  e.intersection_angle_deg =
      deg_from_rad(acute_angle_rad(direction, Eigen::Vector3d(segment.end - segment.start)));
}

std::vector<std::uint32_t> sorted_indices(std::span<const ZonePoint> points) {
  std::vector<std::uint32_t> indices;
  indices.reserve(points.size());
  for (const ZonePoint& p : points) indices.push_back(p.index);
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<std::uint64_t> position_keys(std::span<const ZonePoint> points) {
  constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15ULL;
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  for (const ZonePoint& p : points) {
    std::uint64_t key = 0;
    for (const double coordinate : {p.x.x(), p.x.y(), p.x.z()}) {
      key = (key ^ std::bit_cast<std::uint64_t>(coordinate)) * kMultiplier;
      key ^= key >> 29U;
    }
    keys.push_back(key);
  }
  return keys;
}

std::vector<Eigen::Vector2d> hull_in_plan(std::span<const ZonePoint> points) {
  std::vector<Eigen::Vector2d> xy;
  xy.reserve(points.size());
  for (const ZonePoint& p : points) xy.emplace_back(p.x.head<2>());
  return convex_hull(std::move(xy));
}

/// What the cloud contains around an edge, and which planes judge it.
struct LineSurroundings {
  Footprint footprint;
  std::vector<ZonePoint> zone;
  std::vector<CandidatePlane> candidates;
  SurfaceDecision decision;
};

LineSurroundings surroundings(const PointSearch& search,
                              const JudgedLine& line,
                              const Footprint& footprint,
                              const JudgeOptions& options) {
  LineSurroundings around{
      footprint,
      points_beside(search, footprint, options.fit_half_width_m, options.fit_half_width_m),
      {},
      {}};
  if (count_in_corridor(around.zone, footprint, options) <
      static_cast<std::size_t>(options.min_points)) {
    return around;
  }
  around.candidates = candidate_planes(around.zone, footprint, options, search.normals());
  around.decision = decide_surface(around.zone, around.candidates, footprint, line, options);
  return around;
}

/// The footprint is the image segment projected onto the LIDAR surface, so that all methods use the
/// same points. The line itself is the footprint if there is no image, if the rays meet no surface,
/// or if the line is known to lie on no surface there, as a ray may pass between two points of the
/// cloud.
LineSurroundings surroundings(const PointSearch& search,
                              const JudgedLine& line,
                              const JudgeOptions& options) {
  const std::optional<Segment3> seen = line.images ? monoplot(search, *line.images) : std::nullopt;
  LineSurroundings around =
      surroundings(search, line, footprint_of(seen ? *seen : line.segment), options);
  const bool is_on_surface =
      around.decision.status == Status::kEvaluated && !around.decision.is_far;
  if (!seen || is_on_surface) return around;
  LineSurroundings own = surroundings(search, line, footprint_of(line.segment), options);
  return own.decision.surface && !own.decision.is_far ? std::move(own) : std::move(around);
}

LineEvaluation undecided(const JudgedLine& line) {
  LineEvaluation e;
  e.id = line.id;
  e.line_class = line.line_class;
  e.building = line.building;
  e.epipolar_angle_deg = line.epipolar_angle_deg;
  e.n_images = line.n_images;
  e.class_base = line.class_base;
  if (in_range(line.segment)) {
    e.segment = line.segment;
    e.length_m = length(line.segment);
  }
  return e;
}

JudgedResult ended(LineEvaluation e, Status status, std::string reason) {
  e.status = status;
  e.reason = std::move(reason);
  return {std::move(e), {}, {}, {}, {}};
}

}  // namespace

std::optional<Refusal> refusal_of(const JudgedLine& line) {
  constexpr double kNearVertical = 0.05;  // plan length / length; below it no direction is known
  if (!line.reconstructed) {
    return Refusal{Status::kNotReconstructed, "the file has no geometry for it"};
  }
  if (!line.confirmed) {
    return Refusal{Status::kUnconfirmed, "another image should show it but does not"};
  }
  if (!all_finite(line.segment)) return Refusal{Status::kNonFinite, "a coordinate is not finite"};
  if (!in_range(line.segment)) {
    return Refusal{Status::kOutOfRange, "a coordinate is more than 10,000 km from the cloud"};
  }
  const double length_m = length(line.segment);
  if (!(length_m > 0.0)) return Refusal{Status::kDegenerate, "both ends are the same point"};
  if (length(plan(line.segment)) < kNearVertical * length_m) {
    return Refusal{Status::kDegenerate, "the line is vertical and has no direction in plan"};
  }
  if (length_m < kMinLength_m) {
    return Refusal{Status::kTooShort,
                   text("length ", length_m, " m, must be at least ", kMinLength_m, " m")};
  }
  return std::nullopt;
}

JudgedResult judge_line(const PointSearch& search,
                        const JudgedLine& line,
                        const JudgeOptions& options) {
  LineEvaluation e = undecided(line);
  if (const auto refusal = refusal_of(line)) {
    return ended(std::move(e), refusal->status, refusal->reason);
  }
  LineSurroundings around = surroundings(search, line, options);
  auto& [footprint, zone, candidates, decision] = around;
  const std::size_t n_beside = count_in_corridor(zone, footprint, options);
  if (n_beside < static_cast<std::size_t>(options.min_points)) {
    return ended(std::move(e), Status::kNoLidar,
                 text(n_beside, " points within ", options.corridor_half_width_m,
                      " m of the line, must be at least ", options.min_points));
  }
  if (const double off_m = height_off_m(zone, line.segment);
      marks_missing_height(off_m, line.segment)) {
    return ended(std::move(e), Status::kOutOfRange,
                 text("both ends lie ", std::abs(off_m), off_m > 0.0 ? " m above" : " m below",
                      " all points around them: perhaps a no-data value"));
  }
  e.surface = decision.surface;
  e.surface_other = decision.other;
  e.surface_probability = decision.probability;
  if (decision.status != Status::kEvaluated) {
    return ended(std::move(e), decision.status, std::move(decision.reason));
  }
  if (auto doubt = reason_too_little_known(candidates, decision.planes, footprint, options)) {
    return ended(std::move(e), Status::kAmbiguous, std::move(*doubt));
  }
  e.decided_by = decision.decided_by;
  if (decision.kind == Kind::kRidge) {
    separate_at_intersection(candidates[decision.planes[0]], candidates[decision.planes[1]]);
  }
  JudgedResult result;
  for (const std::size_t i : decision.planes) {
    e.planes.push_back(judging_plane(candidates[i], footprint, line.segment));
    result.inlier_keys.push_back(position_keys(candidates[i].inliers));
    if (options.keep_points) {
      result.inliers.push_back(sorted_indices(candidates[i].inliers));
      result.inlier_points.push_back(positions(candidates[i].inliers));
    }
    result.hulls.push_back(hull_in_plan(candidates[i].inliers));
  }
  e.status = Status::kEvaluated;
  e.kind = decision.kind;
  e.flags = std::move(decision.flags);
  summarise(e, line);
  if (e.kind == Kind::kRidge) {
    compare_with_intersection(e, line.segment);
    // each plane is based on the points of its own side only, which may be few
    if (!reason_too_little_known(candidates, decision.planes, footprint, options)) {
      e.displacement = ridge_displacement(line.segment, {e.planes[0].plane, e.planes[1].plane},
                                          {e.planes[0].sigma_m, e.planes[1].sigma_m});
    }
  } else {
    e.height_if_vertical_m = *e.signed_mean_m / e.planes[0].plane.normal().z();
  }
  result.evaluation = std::move(e);
  return result;
}

}  // namespace ridgeline::evaluate
