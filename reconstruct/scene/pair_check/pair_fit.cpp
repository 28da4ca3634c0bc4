// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/pair_check/pair_fit.h"

#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

using PointPair = std::array<Eigen::Vector2d, 2>;

/// The positions in `other` of the point seen at a pixel of `own`, from the lowest to the highest
/// height.
Segment2 between_heights(const ProjectionMatrix& own,
                         const ProjectionMatrix& other,
                         const Eigen::Vector2d& x_px,
                         const std::array<double, 2>& heights_m) {
  const auto at = [&](double z_m) {
    return project(other, point_on_plane(own, x_px, Plane3(Eigen::Vector3d::UnitZ(), -z_m)));
  };
  return {at(heights_m[0]), at(heights_m[1])};
}

std::optional<PointPair> ideal_pair(const PointMatch& match, const PairGeometry& geometry) {
  PointPair ideal = match.x_px;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!geometry.ideal_from_image[i]) continue;
    const auto x_px = geometry.ideal_from_image[i](ideal[i]);
    if (!x_px) return std::nullopt;
    ideal[i] = *x_px;
  }
  return ideal;
}

std::vector<PairReading> readings_to_try() {
  std::vector<PairReading> readings{{.swapped = true}};
  for (const int angle : {180, 90, 270}) {
    readings.push_back({.turned_deg = {angle, angle}});
    readings.push_back({.turned_deg = {angle, 0}});
    readings.push_back({.turned_deg = {0, angle}});
  }
  for (const double scale : {0.5, 2.0}) {
    readings.push_back({.scale = {scale, scale}});
    readings.push_back({.scale = {scale, 1.0}});
    readings.push_back({.scale = {1.0, scale}});
  }
  return readings;
}

Eigen::Vector2d turned_back(const Eigen::Vector2d& x_px, const Eigen::Vector2i& size, int angle) {
  const Eigen::Vector2d last = (size.array() - 1).cast<double>();
  switch (angle) {
    case 90:
      return {x_px.y(), last.x() - x_px.x()};
    case 180:
      return last - x_px;
    case 270:
      return {last.y() - x_px.y(), x_px.x()};
    default:
      return x_px;
  }
}

}  // namespace

PairFit fit_of_pair(std::span<const PointMatch> points,
                    const PairGeometry& geometry,
                    double limit_px) {
  const auto& cameras = geometry.image_from_local;
  const Eigen::Matrix3d right_from_left = fundamental_matrix(cameras[0], cameras[1]);
  std::vector<double> parallaxes_px;
  std::size_t n_fit = 0;
  for (const PointMatch& match : points) {
    const std::optional<PointPair> x = ideal_pair(match, geometry);
    if (!x) continue;
    const auto& [left, right] = *x;
    parallaxes_px.push_back(0.5 * (epipolar_distance_px(right_from_left, left, right) +
                                   epipolar_distance_px(right_from_left.transpose(), right, left)));
    const double off_px =
        0.5 * (distance(between_heights(cameras[0], cameras[1], left, geometry.heights_m), right) +
               distance(between_heights(cameras[1], cameras[0], right, geometry.heights_m), left));
    if (off_px <= limit_px) ++n_fit;
  }
  const std::size_t n = parallaxes_px.size();
  if (n == 0) return {0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  return {n, upper_median(std::move(parallaxes_px)), double(n_fit) / double(n)};
}

PointMatch as_seen(const PointMatch& file_points,
                   const std::array<Eigen::Vector2i, 2>& sizes_px,
                   const PairReading& reading) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  PointMatch seen;
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2d x_px =
        turned_back(file_points.x_px[i], sizes_px[i], reading.turned_deg[i]);
    seen.x_px[i] = (x_px + half) / reading.scale[i] - half;
  }
  if (reading.swapped) std::swap(seen.x_px[0], seen.x_px[1]);
  return seen;
}

std::vector<PairReading> fitting_readings(std::span<const PointMatch> points,
                                          const std::array<Eigen::Vector2i, 2>& sizes_px,
                                          const PairGeometry& geometry,
                                          double limit_px) {
  constexpr double kMinShare = 0.5;
  constexpr double kNearlyAsGood = 0.9;
  std::vector<PairReading> readings = readings_to_try();
  std::vector<double> shares;
  for (const PairReading& reading : readings) {
    const std::vector<PointMatch> seen = transformed(
        points, [&](const PointMatch& match) { return as_seen(match, sizes_px, reading); });
    shares.push_back(fit_of_pair(seen, geometry, limit_px).share_that_fits);
  }
  const double least =
      std::max(kMinShare, kNearlyAsGood * *std::max_element(shares.begin(), shares.end()));
  std::vector<PairReading> fitting;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (shares[i] >= least) fitting.push_back(readings[i]);
  }
  return fitting;
}

}  // namespace ridgeline::reconstruct
