// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ball_cover.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

Eigen::Vector2d direction_of(const Segment2& segment) {
  const Eigen::Vector2d way = segment.end - segment.start;
  const double length_m = way.norm();
  return length_m > 0.0 ? Eigen::Vector2d(way / length_m) : Eigen::Vector2d::UnitX();
}

}  // namespace

BallCover::CoverSteps BallCover::CoverSteps::over(double from_m, double to_m, double longest_m) {
  // a bird a kilometre up must not cause thousands of empty balls
  constexpr double kMaxSteps = 256.0;
  if (to_m < from_m) return {};
  if (!(longest_m > 0.0)) return {from_m, to_m - from_m, 1};
  const int count =
      static_cast<int>(std::clamp(std::ceil((to_m - from_m) / longest_m), 1.0, kMaxSteps));
  return {from_m, (to_m - from_m) / count, count};
}

int BallCover::CoverSteps::at(double x_m) const {
  if (!(step_m > 0.0)) return 0;
  return static_cast<int>(std::clamp((x_m - from_m) / step_m, 0.0, count - 1.0));
}

/// The part of the corridor that overlaps the extent, in steps.
BallCover::CoverSteps BallCover::steps_along(const Segment2& segment,
                                             const Eigen::Vector2d& direction,
                                             double radius_m,
                                             const Eigen::AlignedBox3d& extent) {
  const Eigen::Vector2d across(-direction.y(), direction.x());
  // the extent is enlarged by a radius, so that rounding loses no point at the border
  const Eigen::Vector2d half = 0.5 * extent.sizes().head<2>().array() + radius_m;
  const Eigen::Vector2d centre = Eigen::Vector2d(extent.center().head<2>()) - segment.start;
  const double reach_m = direction.cwiseAbs().dot(half);
  if (std::abs(across.dot(centre)) > across.cwiseAbs().dot(half) + radius_m) return {};
  const double s_m = direction.dot(centre);
  return CoverSteps::over(std::max(-radius_m, s_m - reach_m),
                          std::min(length(segment) + radius_m, s_m + reach_m), 2.0 * radius_m);
}

BallCover::BallCover(const Segment2& segment, double radius_m, const Eigen::AlignedBox3d& extent)
    : start_(segment.start),
      direction_(direction_of(segment)),
      along_(extent.isEmpty() ? CoverSteps{} : steps_along(segment, direction_, radius_m, extent)),
      up_(extent.isEmpty() ? CoverSteps{}
                           : CoverSteps::over(extent.min().z(), extent.max().z(), 2.0 * radius_m)),
      ball_radius_m_(0.5 * Eigen::Vector3d(along_.step_m, 2.0 * radius_m, up_.step_m).norm()) {}

Ball BallCover::ball(int i) const {
  const Eigen::Vector2d xy = start_ + along_.centre(i / up_.count) * direction_;
  return {{xy.x(), xy.y(), up_.centre(i % up_.count)}, ball_radius_m_};
}

int BallCover::ball_of(const Eigen::Vector3d& x) const {
  const int along = along_.at(direction_.dot(x.head<2>() - start_));
  return along * up_.count + up_.at(x.z());
}

}  // namespace ridgeline::evaluate
