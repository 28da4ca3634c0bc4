// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/candidate_points.h"

#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

#include <optional>

namespace ridgeline::reconstruct {
namespace {

double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& line) {
  return std::abs(line.dot(point)) / (line.head<2>().norm() * std::abs(point.z()));
}

/// Two lines in the views that show both, and where they cross in each (Eq. 2).
struct Crossings {
  std::vector<SeenTogether> seen;
  std::vector<UncertainPoint2> x;
};

Crossings crossings(const ObservedTrack& line, const ObservedTrack& counterpart) {
  Crossings all{seen_together(line, counterpart), {}};
  for (const SeenTogether& view : all.seen)
    all.x.push_back(spherically_normalised(cross(view.line.line, view.other.line)));
  return all;
}

/// The epipolar line in the first view comes from the second one; in all other views, from the
/// first one.
PairMeasures measures(const ConditionedViews& frames, const Crossings& crossings) {
  std::vector<PairMeasures> images;
  for (std::size_t j = 0; j < crossings.seen.size(); ++j) {
    const auto& [line, other] = crossings.seen[j];
    const std::size_t counterpart = j == 0 ? 1 : 0;
    const Eigen::Vector3d epipolar_line =
        frames.fundamental(crossings.seen[counterpart].line.view, line.view) *
        crossings.x[counterpart].mean;
    const double scale_px = frames.of(line).image.scale_px;
    images.push_back({scale_px * distance(line.segment, other.segment),
                      scale_px * distance_to_line(crossings.x[j].mean, epipolar_line),
                      acute_angle_rad(line.segment, other.segment)});
  }
  return smallest_of_each(images);
}

std::optional<CandidatePoint> candidate_point(const TrackedLines& lines,
                                              const ObservedTrack& line,
                                              int neighbour) {
  const ObservedTrack& counterpart = lines.lines[static_cast<std::size_t>(neighbour)];
  const Crossings both = crossings(line, counterpart);
  if (both.seen.size() < 2) return std::nullopt;
  const double weight = point_weight(measures(lines.frames, both));
  if (weight <= 0.0) return std::nullopt;

  std::vector<ViewedPoint> observations;
  for (std::size_t j = 0; j < both.seen.size(); ++j)
    observations.push_back({lines.frames.of(both.seen[j].line).image_from_object, both.x[j]});
  const std::optional<EstimatedPoint> estimated = estimate_point(observations);
  if (!estimated || !plausible(lines, line, estimated->point.mean)) return std::nullopt;
  CandidatePoint candidate{*estimated, {0.0, weight, estimated->omega, neighbour}};
  const bool base_shows_both = both.seen[0].line.view == line.base().view;
  candidate.ranked.parameter = parameter_along(
      line.base().segment, base_shows_both ? Eigen::Vector2d(both.x[0].mean.hnormalized())
                                           : crossing_in_view(lines, line.base(), candidate));
  return candidate;
}

}  // namespace

Eigen::Vector2d crossing_in_view(const TrackedLines& lines,
                                 const ObservedLine& seen,
                                 const CandidatePoint& point) {
  for (const ObservedLine& other :
       lines.lines[static_cast<std::size_t>(point.ranked.neighbour)].observations) {
    if (other.view == seen.view) return SeenTogether{seen, other}.crossing();
  }
  return (lines.frames.of(seen).image_from_object * point.estimated.point.mean).hnormalized();
}

double pair_weight(const TrackedLines& lines, const ObservedTrack& line, int neighbour) {
  const Crossings both = crossings(line, lines.lines[static_cast<std::size_t>(neighbour)]);
  return both.seen.size() < 2 ? 0.0 : point_weight(measures(lines.frames, both));
}

bool plausible(const TrackedLines& lines, const ObservedTrack& line, const Eigen::Vector4d& x) {
  for (const ObservedLine& seen : line.observations) {
    if (!in_front(lines.frames.of(seen), x)) return false;
  }
  const double height_m = lines.frames.object.local_from_conditioned(x.hnormalized()).z();
  const auto& [lowest_m, highest_m] = lines.height_range_in_local_m;
  return height_m >= lowest_m && height_m <= highest_m;
}

std::vector<CandidatePoint> candidate_points(const TrackedLines& lines,
                                             const ObservedTrack& line,
                                             std::span<const int> neighbours) {
  std::vector<CandidatePoint> points;
  for (const int neighbour : neighbours) {
    if (const auto point = candidate_point(lines, line, neighbour)) points.push_back(*point);
  }
  return points;
}

}  // namespace ridgeline::reconstruct
