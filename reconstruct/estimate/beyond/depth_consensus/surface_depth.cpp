// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/surface_depth.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kNonsense = 0.015;        // share of lines with a wrong surface beside them
constexpr double kMinSigmaAlong_px = 0.3;  // minimum sigma of a homologous point along the line

}  // namespace

SurfaceDepth::SurfaceDepth(const Surface& surface,
                           const TrackedLines& lines,
                           const ObservedTrack& line)
    : surface_(surface), lines_(lines), line_(line) {
  const Segment2 whole{rectified(line.base().segment.start), rectified(line.base().segment.end)};
  for (const SidesOfPiece& piece : sides_along(surface, whole)) add_stations(piece);
}

Eigen::Vector2d SurfaceDepth::rectified(const Eigen::Vector2d& x_in_left) const {
  return surface_.rectification.rectified(
      0, lines_.frames.of(line_.base()).image.image_from_conditioned(x_in_left));
}

/// Adds the stations of a piece, provided that the nearer surface is trusted.
void SurfaceDepth::add_stations(const SidesOfPiece& piece) {
  const SidePlane* nearer = piece.nearer();
  if (nearer == nullptr || !nearer->is_trusted()) return;
  // A single plane also determines the direction of the line, so it gives two stations.
  const bool is_single = piece.parameters == std::array{0.0, 1.0};
  for (const double share : is_single ? std::vector{0.2, 0.8} : std::vector{0.5}) {
    const double t_px = (share - 0.5) * piece.length_px;
    add_station(std::lerp(piece.parameters[0], piece.parameters[1], share), nearer->on_line(t_px),
                nearer->sigma_on_line_px(t_px));
  }
}

/// Adds a station.
/// @param parameter  position along the rectified segment, which hardly differs from that along the
///                   segment
void SurfaceDepth::add_station(double parameter, double d_px, double sigma_px) {
  const Segment2& segment = line_.base().segment;
  const Eigen::Vector2d x = point_at(segment, parameter);
  const Eigen::Vector3d on_surface = surface_.rectification.point_in_local(rectified(x), d_px);
  stations_.push_back({parameter, d_px, sigma_px,
                       plane_across(lines_.frames.of(line_.base()).image_from_object, x,
                                    segment.end - segment.start),
                       lines_.frames.object.conditioned_from_local(on_surface)});
}

double SurfaceDepth::misfit(const Station& station, const DepthLine& line) const {
  const double s = -station.across.dot(line.through.homogeneous()) /
                   station.across.head<3>().dot(line.direction);
  const Eigen::Vector3d x = line.through + s * line.direction;
  const double d =
      surface_.rectification.disparity_px(lines_.frames.object.local_from_conditioned(x));
  return (d - station.d_px) / station.sigma_px;
}

double SurfaceDepth::log_likelihood(const LineAt& profile) const {
  if (stations_.empty()) return 0.0;
  double squares = 0.0;
  for (const Station& station : stations_) {
    squares += std::pow(misfit(station, profile(station.parameter)), 2.0);
  }
  const double mean = squares / static_cast<double>(stations_.size());
  return std::log(kNonsense + (1.0 - kNonsense) * std::exp(-0.5 * mean));
}

std::vector<DepthLine> SurfaceDepth::likely_lines(const Eigen::Vector3d& horizontal) const {
  std::vector<DepthLine> lines;
  for (const Station& s : stations_) {
    if (!horizontal.isZero()) lines.push_back({s.point, horizontal});
  }
  if (stations_.size() > 1) {
    lines.push_back(
        {stations_.front().point, (stations_.back().point - stations_.front().point).normalized()});
  }
  return lines;
}

/// The positions in both images of a point of the left segment with a given disparity. The right
/// one is moved onto the right segment.
std::array<Eigen::Vector2d, 2> SurfaceDepth::seen(double parameter, double d_px) const {
  const Rectification& r = surface_.rectification;
  const Eigen::Vector2d left = point_at(line_.base().segment, parameter);
  const Eigen::Vector2d x = rectified(left);
  const Eigen::Vector3d right =
      r.rectified_from_ideal[1].inverse() * Eigen::Vector3d(x.x() - d_px, x.y(), 1.0);
  const Segment2& axis = line_.other().segment;
  const Eigen::Vector2d in_right =
      lines_.frames.of(line_.other()).image.conditioned_from_image(right.hnormalized());
  return {left, point_at(axis, parameter_along(axis, in_right))};
}

std::optional<std::array<SurfaceDepth::Homologous, 2>> SurfaceDepth::homologous(
    const DepthLine& line) const {
  constexpr double kMaxOffset = 3.0;       // in standard deviations, RMS
  constexpr std::array kPlaces{0.1, 0.9};  // along the segment
  if (stations_.size() < 2) return std::nullopt;
  double squares = 0.0;
  // Normal equations of a straight line in the disparities.
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const Station& s : stations_) {
    squares += std::pow(misfit(s, line), 2.0);
    const Eigen::Vector2d by(1.0, s.parameter);
    normal += by * by.transpose() / (s.sigma_px * s.sigma_px);
    right += by * s.d_px / (s.sigma_px * s.sigma_px);
  }
  if (squares > kMaxOffset * kMaxOffset * static_cast<double>(stations_.size()))
    return std::nullopt;
  const Eigen::Matrix2d cov = normal.inverse();
  std::array<Homologous, 2> points;
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const Eigen::Vector2d by(1.0, kPlaces[i]);
    points[i] = {seen(kPlaces[i], by.dot(cov * right)),
                 std::max(kMinSigmaAlong_px, std::sqrt(by.dot(cov * by)))};
  }
  return points;
}

}  // namespace ridgeline::reconstruct
