// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/candidate_points.h"

#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

#include <optional>

namespace ridgeline::reconstruct {
namespace {

using ImagePoints = std::array<UncertainPoint2, 2>;

double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& line) {
  return std::abs(line.dot(point)) / (line.head<2>().norm() * std::abs(point.z()));
}

PairMeasures measures(const StereoLines& lines,
                      const ObservedPair& line,
                      int neighbour,
                      const ImagePoints& x) {
  const std::array<Eigen::Vector3d, 2> epipolar_line{lines.right_from_left.transpose() * x[1].mean,
                                                     lines.right_from_left * x[0].mean};
  const auto in_image = [&](std::size_t j) {
    const Segment2& a = line[j].segment;
    const Segment2& b = lines.lines[static_cast<std::size_t>(neighbour)][j].segment;
    const double scale_px = lines.stereo.views[j].image.scale_px;
    return PairMeasures{scale_px * distance(a, b),
                        scale_px * distance_to_line(x[j].mean, epipolar_line[j]),
                        acute_angle_rad(a, b)};
  };
  return smaller_of_each({in_image(0), in_image(1)});
}

/// Where the lines cross in each image (Eq. 2).
ImagePoints crossings(const ObservedPair& line, const ObservedPair& mate) {
  ImagePoints x;
  for (std::size_t j = 0; j < 2; ++j) {
    x[j] = spherically_normalised(cross(line[j].line, mate[j].line));
  }
  return x;
}

std::optional<CandidatePoint> candidate_point(const StereoLines& lines,
                                              const ObservedPair& line,
                                              int neighbour,
                                              const ReconstructOptions& options) {
  const ObservedPair& mate = lines.lines[static_cast<std::size_t>(neighbour)];
  const ImagePoints x = crossings(line, mate);
  const double weight = point_weight(measures(lines, line, neighbour, x), options);
  if (weight <= 0.0) return std::nullopt;

  const std::array<PointObservation, 2> observations{
      PointObservation{lines.stereo.views[0].image_from_object, x[0]},
      PointObservation{lines.stereo.views[1].image_from_object, x[1]}};
  const std::optional<EstimatedPoint> estimated = estimate_point(observations);
  if (!estimated || !plausible(lines, estimated->point.mean)) return std::nullopt;
  const double parameter = parameter_along(line[0].segment, x[0].mean.hnormalized());
  return CandidatePoint{*estimated, {parameter, weight, estimated->omega, neighbour}};
}

}  // namespace

double pair_weight(const StereoLines& lines,
                   const ObservedPair& line,
                   int neighbour,
                   const ReconstructOptions& options) {
  const ImagePoints x = crossings(line, lines.lines[static_cast<std::size_t>(neighbour)]);
  return point_weight(measures(lines, line, neighbour, x), options);
}

bool plausible(const StereoLines& lines, const Eigen::Vector4d& x) {
  for (const ConditionedView& view : lines.stereo.views) {
    if (!in_front(view, x)) return false;
  }
  const double height_m = lines.stereo.object.local_from_conditioned(x.hnormalized()).z();
  const auto& [lowest_m, highest_m] = lines.height_range_in_local_m;
  return height_m >= lowest_m && height_m <= highest_m;
}

std::vector<CandidatePoint> candidate_points(const StereoLines& lines,
                                             const ObservedPair& line,
                                             std::span<const int> neighbours,
                                             const ReconstructOptions& options) {
  std::vector<CandidatePoint> points;
  for (const int neighbour : neighbours) {
    if (const auto point = candidate_point(lines, line, neighbour, options)) {
      points.push_back(*point);
    }
  }
  return points;
}

}  // namespace ridgeline::reconstruct
