// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/plane_lines.h"

#include "reconstruct/estimate/beyond/roof_planes/plane_faces.h"
#include "reconstruct/estimate/beyond/roof_planes/plane_intersection.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kMinBend = 0.08;  // difference of the planes' slopes, disparity per pixel
// Largest distance of the border from the intersection.
constexpr double kFromIntersection_px = 1.0 * PlaneFaces::kCell_px;
constexpr double kMinShareOnLine = 0.6;  // share of the border that must lie on the line
constexpr double kMaxGap_px = 2.5 * PlaneFaces::kCell_px;
constexpr double kMinIntersectionLength_px = 20.0;
// Sigma of an end along the line: the extent of the faces is uncertain.
constexpr double kSigmaEnd_px = 0.5 * PlaneFaces::kCell_px;

/// The points where two faces border on each other: midpoints between their cells.
using Borders = std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>>;

Borders borders_of(const PlaneFaces& faces) {
  Borders borders;
  const cv::Mat& cells = faces.face_of_cell;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.cols; ++column) {
      const int own = cells.at<int>(row, column);
      if (own < 0) continue;
      for (const auto& [down, right] : {std::pair(0, 1), std::pair(1, 0)}) {
        for (const int step : {1, 2}) {  // a cell of neither face may lie between them
          const int r = row + step * down;
          const int c = column + step * right;
          if (r >= cells.rows || c >= cells.cols) break;
          const int other = cells.at<int>(r, c);
          if (other == own) break;
          if (other < 0) continue;
          borders[std::minmax(own, other)].push_back(
              0.5 * (PlaneFaces::centre_px(row, column) + PlaneFaces::centre_px(r, c)));
          break;
        }
      }
    }
  }
  return borders;
}

/// The part of the intersection of two planes along which their faces border on each other,
/// rectified.
std::optional<Segment2> crease(const PlaneFace& a,
                               const PlaneFace& b,
                               const std::vector<Eigen::Vector2d>& border) {
  const Eigen::Vector3d difference = a.plane - b.plane;
  const double bend = difference.head<2>().norm();
  if (bend < kMinBend) return std::nullopt;
  const Eigen::Vector3d line = difference / bend;
  const Eigen::Vector2d along(-line.y(), line.x());
  std::vector<double> on_line;
  for (const Eigen::Vector2d& x : border) {
    if (std::abs(line.dot(x.homogeneous())) <= kFromIntersection_px)
      on_line.push_back(along.dot(x));
  }
  if (static_cast<double>(on_line.size()) < kMinShareOnLine * static_cast<double>(border.size()))
    return std::nullopt;
  std::ranges::sort(on_line);
  std::array<double, 2> longest{0.0, 0.0};
  double from = on_line.front();
  for (std::size_t i = 0; i < on_line.size(); ++i) {
    if (i > 0 && on_line[i] - on_line[i - 1] > kMaxGap_px) from = on_line[i];
    if (on_line[i] - from > longest[1] - longest[0]) longest = {from, on_line[i]};
  }
  if (longest[1] - longest[0] + PlaneFaces::kCell_px < kMinIntersectionLength_px)
    return std::nullopt;
  const Eigen::Vector2d foot = -line.z() * line.head<2>();
  return Segment2{foot + longest[0] * along, foot + longest[1] * along};
}

Matrix6d covariance(const PointOfPlanes& start,
                    const PointOfPlanes& end,
                    const PlaneFace& a,
                    const PlaneFace& b,
                    double m_per_px) {
  Matrix6d of_planes = Matrix6d::Zero();
  of_planes.topLeftCorner<3, 3>() = a.cov;
  of_planes.bottomRightCorner<3, 3>() = b.cov;
  Matrix6d by_planes;
  by_planes << start.by_planes, end.by_planes;
  Matrix6d cov = propagated(by_planes, of_planes);
  const Eigen::Vector3d along =
      kSigmaEnd_px * m_per_px * (end.x_in_local - start.x_in_local).normalized();
  cov.topLeftCorner<3, 3>() += along * along.transpose();
  cov.bottomRightCorner<3, 3>() += along * along.transpose();
  return cov;
}

/// Whether known lines run along a line, to within the tolerance, over half of its length.
bool is_known(const Segment3& line, std::span<const ReconstructedLine> known) {
  constexpr int kSamples = 11;
  constexpr double kTolerance_m = 0.3;
  constexpr double kParallel_rad = 15.0 * kRadPerDeg;
  const Eigen::Vector3d along = line.end - line.start;
  std::vector<Segment3> beside;
  for (const ReconstructedLine& k : known) {
    if (!k.segment_in_local) continue;
    const Eigen::Vector3d other = k.segment_in_local->end - k.segment_in_local->start;
    if (acute_angle_rad(other, along) <= kParallel_rad) beside.push_back(*k.segment_in_local);
  }
  int n_known = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::Vector3d x = point_at(line, static_cast<double>(i) / (kSamples - 1));
    n_known += std::ranges::any_of(
        beside, [&](const Segment3& k) { return distance(k, x) <= kTolerance_m; });
  }
  return 2 * n_known >= kSamples;
}

ReconstructedLine line_of(const StereoPair& pair,
                          const Rectification& r,
                          const PlaneFace& a,
                          const PlaneFace& b,
                          const Segment2& crease,
                          double max_aligned_angle_deg) {
  const PointOfPlanes start = point_of_planes(r, a.plane, b.plane, crease.start);
  const PointOfPlanes end = point_of_planes(r, a.plane, b.plane, crease.end);
  ReconstructedLine line;
  line.determination = Determination::kPlanes;
  line.failure.reset();
  line.segment_in_local = {start.x_in_local, end.x_in_local};
  line.covariance_m2 =
      covariance(start, end, a, b, length(*line.segment_in_local) / length(crease));
  const std::array<ProjectionMatrix, 2> cameras = pair.cameras();
  for (const std::size_t view : {0U, 1U})
    line.observations.push_back({{view, -1}, project(cameras[view], *line.segment_in_local)});
  line.epipolar_angle_rad = epipolar_angle_rad(cameras, line.base().px, line.other().px);
  line.line_class = line.epipolar_angle_rad <= max_aligned_angle_deg * kRadPerDeg
                        ? LineClass::kAligned
                        : LineClass::kNotAligned;
  return line;
}

}  // namespace

std::vector<ReconstructedLine> plane_lines(const StereoPair& pair,
                                           const Surface& surface,
                                           std::span<const ReconstructedLine> known,
                                           double max_aligned_angle_deg) {
  const Rectification& r = surface.rectification;
  const PlaneFaces faces = plane_faces(surface);
  std::vector<ReconstructedLine> lines;
  for (const auto& [both, border] : borders_of(faces)) {
    const PlaneFace& a = faces.faces[static_cast<std::size_t>(both.first)];
    const PlaneFace& b = faces.faces[static_cast<std::size_t>(both.second)];
    const auto found = crease(a, b, border);
    if (!found) continue;
    ReconstructedLine line = line_of(pair, r, a, b, *found, max_aligned_angle_deg);
    if (!is_known(*line.segment_in_local, known)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace ridgeline::reconstruct
