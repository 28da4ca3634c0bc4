// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/line_geometry.h"

#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ridgeline::reconstruct {
namespace {

/// The plane through the image line that is normal to the segment at `x`. Only the position of x
/// along the segment contributes to its uncertainty.
UncertainPlane3 end_plane(const ConditionedView& view,
                          const ObservedLine& observed,
                          const Eigen::Vector2d& x) {
  const Eigen::Vector2d u = along(observed.segment);
  UncertainLine2 across{Eigen::Vector3d(u.x(), u.y(), -u.dot(x)), Eigen::Matrix3d::Zero()};
  across.cov(2, 2) = observed.sigma_e * observed.sigma_e;
  return projection_plane(view.image_from_object, across);
}

struct Endpoint {
  Eigen::Vector4d point;
  Eigen::Matrix<double, 3, 6> jacobian;  ///< derivative of the Euclidean point by the line
  Eigen::Matrix3d cov_along;             ///< contribution of the image endpoint to the covariance
};

/// The endpoint X = Gamma(L) B with dX/dL = -Pi'(B), dX/dB = Gamma(L).
Endpoint endpoint(const UncertainLine3& line, const UncertainPlane3& plane) {
  const Eigen::Matrix4d gamma = gamma_matrix(line.mean);
  const Eigen::Vector4d point = gamma * plane.mean;
  const Eigen::Matrix<double, 3, 4> euclidean = euclidean_jacobian(point);
  const Eigen::Matrix<double, 3, 4> by_plane = euclidean * gamma;
  return {point, -euclidean * pi_matrix(plane.mean).transpose(), propagated(by_plane, plane.cov)};
}

Segment3 local_from_conditioned(const ObjectConditioning& object, const Segment3& s) {
  return {object.local_from_conditioned(s.start), object.local_from_conditioned(s.end)};
}

UncertainSegment3 joined(const UncertainLine3& line, const Endpoint& start, const Endpoint& end) {
  Matrix6d jacobian;
  jacobian << start.jacobian, end.jacobian;
  Matrix6d cov = propagated(jacobian, line.cov);
  cov.topLeftCorner<3, 3>() += start.cov_along;
  cov.bottomRightCorner<3, 3>() += end.cov_along;
  return {{start.point.hnormalized(), end.point.hnormalized()}, cov};
}

/// How far a view shows a line, towards one end.
struct EndReach {
  Endpoint end;
  double parameter = 0.0;  ///< along the line, towards that end
  double sigma = 0.0;      ///< of the parameter
};

/// The farthest end that two views show: the middle one of the views that agree with the second
/// farthest one.
Endpoint end_of_two_views(std::vector<EndReach> by_view) {
  constexpr double kAgreeingSigma = 3.0;
  std::ranges::sort(by_view, std::greater{}, &EndReach::parameter);
  const EndReach second = by_view[1];
  std::erase_if(by_view, [&](const EndReach& r) {
    return std::abs(r.parameter - second.parameter) >
           kAgreeingSigma * std::hypot(r.sigma, second.sigma);
  });
  return by_view[by_view.size() / 2].end;
}

/// The part of a line that two views show; empty if there is no such part.
std::optional<UncertainSegment3> part_of_two_views(const ConditionedViews& frames,
                                                   const ObservedTrack& track,
                                                   const UncertainLine3& line,
                                                   const Segment3& base) {
  std::map<std::size_t, std::array<EndReach, 2>> by_view;  // towards the start, towards the end
  for (const ObservedLine& observed : track.observations) {
    std::array<EndReach, 2> ends;
    for (const auto& [i, x] :
         {std::pair(0, observed.segment.start), std::pair(1, observed.segment.end)})
      ends[i].end = endpoint(line, end_plane(frames.of(observed), observed, x));
    for (EndReach& r : ends) r.parameter = parameter_along(base, r.end.point.hnormalized());
    if (ends[0].parameter > ends[1].parameter) std::swap(ends[0], ends[1]);
    const double sigma =
        observed.sigma_e * (ends[1].parameter - ends[0].parameter) / length(observed.segment);
    ends[0].parameter *= -1.0;
    for (EndReach& r : ends) r.sigma = sigma;
    const auto [known, is_first] = by_view.try_emplace(observed.view, ends);
    if (is_first) continue;
    for (const std::size_t i : {0U, 1U}) {
      if (ends[i].parameter > known->second[i].parameter) known->second[i] = ends[i];
    }
  }
  std::array<std::vector<EndReach>, 2> reaches;
  for (const auto& [view, ends] : by_view) {
    for (const std::size_t i : {0U, 1U}) reaches[i].push_back(ends[i]);
  }
  const Endpoint start = end_of_two_views(reaches[0]);
  const Endpoint end = end_of_two_views(reaches[1]);
  const UncertainSegment3 part = joined(line, start, end);
  const bool runs_along = (part.segment.end - part.segment.start).dot(base.end - base.start) > 0.0;
  return runs_along ? std::optional(part) : std::nullopt;
}

}  // namespace

std::optional<UncertainSegment3> endpoints(const UncertainLine3& line,
                                           const ConditionedView& view,
                                           const ObservedLine& observed,
                                           std::span<const ConditionedView> views) {
  const Endpoint start = endpoint(line, end_plane(view, observed, observed.segment.start));
  const Endpoint end = endpoint(line, end_plane(view, observed, observed.segment.end));
  const bool visible = std::all_of(views.begin(), views.end(), [&](const ConditionedView& v) {
    return in_front(v, start.point) && in_front(v, end.point);
  });
  if (!visible) return std::nullopt;  // a point at infinity is not in front either
  return joined(line, start, end);
}

double largest_sigma_z_m(const Matrix6d& cov_m2) {
  return std::sqrt(std::max(cov_m2(2, 2), cov_m2(5, 5)));
}

bool assign_geometry(const TrackedLines& lines,
                     const ObservedTrack& track,
                     const UncertainLine3& estimate,
                     ReconstructedLine& result) {
  const ConditionedViews& frames = lines.frames;
  const auto views =
      transformed(track.observations, [&](const ObservedLine& s) { return frames.of(s); });
  const auto base = endpoints(estimate, frames.of(track.base()), track.base(), views);
  if (!base) return false;
  const auto other = endpoints(estimate, frames.of(track.other()), track.other(), views);
  const ObjectConditioning& object = frames.object;
  UncertainSegment3 used = *base;
  // a part of a cut track ends where its base segment was cut
  const bool is_common = lines.common_part && result.part == 0;
  if (is_common || track.observations.size() > 2)
    used = part_of_two_views(frames, track, estimate, base->segment).value_or(used);
  result.segment_in_local = local_from_conditioned(object, used.segment);
  result.covariance_m2 = object.scale_m * object.scale_m * used.cov;
  result.other_segment_in_local.reset();
  if (other) result.other_segment_in_local = local_from_conditioned(object, other->segment);
  return true;
}

}  // namespace ridgeline::reconstruct
