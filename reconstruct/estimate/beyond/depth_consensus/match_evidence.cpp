// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/match_evidence.h"

#include <Eigen/LU>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

/// The probability, at W = 1, that two lines that cross in both images meet in space.
constexpr double kMaxPointPrior = 0.7;
/// The probability that the ends of both segments show the same point.
constexpr double kEndPrior = 0.75;
constexpr double kMinCutLength_px = 7.0;  // of each part of a match that is cut (calibration.md)
constexpr double kMinCutWeight = 0.3;     // minimum weight W of a point where a track may be cut

/// The end of a segment as an uncertain point. Its sigma along the line is sigma_end; across the
/// line, it is the sigma of the line.
UncertainPoint2 end_in_image(const ObservedLine& observed,
                             const Eigen::Vector2d& end,
                             double sigma_end) {
  const Eigen::Vector2d u = along(observed.segment);
  const Eigen::Vector2d n = normal_of(u);
  const Eigen::Vector3d x = end.homogeneous();
  const double norm = observed.line.mean.head<2>().norm();
  const double variance_across = x.dot(observed.line.cov * x) / (norm * norm);
  UncertainPoint2 point{x, Eigen::Matrix3d::Zero()};
  point.cov.topLeftCorner<2, 2>() =
      sigma_end * sigma_end * u * u.transpose() + variance_across * n * n.transpose();
  return spherically_normalised(point);
}

/// The position in another view of the point that the base view shows at a pixel, assuming that the
/// point is at the height of the patch's centre.
Eigen::Vector2d on_level(const ConditionedView& base,
                         const ConditionedView& other,
                         const Eigen::Vector2d& x_in_base) {
  const ProjectionMatrix& camera = base.image_from_object;
  Eigen::Matrix3d image_from_level;  // maps (X, Y, 1) to the base view
  image_from_level << camera.col(0), camera.col(1), camera.col(3);
  const Eigen::Vector3d x = image_from_level.inverse() * x_in_base.homogeneous();
  return (other.image_from_object * Eigen::Vector4d(x.x(), x.y(), 0.0, x.z())).hnormalized();
}

bool is_reversed(const ConditionedViews& frames, const ObservedTrack& line) {
  const Segment2& segment = line.base().segment;
  const auto in_other = [&](const Eigen::Vector2d& x) {
    return on_level(frames.of(line.base()), frames.of(line.other()), x);
  };
  const Eigen::Vector2d expected = in_other(segment.end) - in_other(segment.start);
  return expected.dot(line.other().segment.end - line.other().segment.start) < 0.0;
}

DepthEvidence evidence_of(const UncertainPoint3& point, double parameter, double prior) {
  const Eigen::Matrix<double, 3, 4> jacobian = euclidean_jacobian(point.mean);
  return {point.mean.hnormalized(), propagated(jacobian, point.cov), parameter, prior};
}

/// Whether the track may be cut where it meets another one. The meeting must have enough weight,
/// and both parts must be long enough in both images.
bool may_cut(const AlignedTrack& track, const CandidatePoint& at) {
  if (at.ranked.weight < kMinCutWeight) return false;
  const auto x = track.places_of(at);
  for (std::size_t j = 0; j < 2; ++j) {
    const double shortest =
        kMinCutLength_px / track.lines.frames.of(track.line.observations[j]).image.scale_px;
    const Segment2& segment = track.line.observations[j].segment;
    const double to_end = std::min((x[j] - segment.start).norm(), (x[j] - segment.end).norm());
    if (!(distance(segment, x[j]) < 1e-9 && to_end >= shortest)) return false;
  }
  return true;
}

}  // namespace

AlignedTrack::AlignedTrack(const TrackedLines& all, const ObservedTrack& observed)
    : lines(all), line(observed), runs_back(is_reversed(all.frames, observed)) {}

std::array<Eigen::Vector2d, 2> AlignedTrack::ends(int which) const {
  const auto end = [](const Segment2& s, bool at_start) { return at_start ? s.start : s.end; };
  return {end(line.base().segment, which == 0),
          end(line.other().segment, (which == 0) != runs_back)};
}

std::array<Eigen::Vector2d, 2> AlignedTrack::places_of(const CandidatePoint& point) const {
  return {crossing_in_view(lines, line.base(), point),
          crossing_in_view(lines, line.other(), point)};
}

std::optional<UncertainPoint3> point_in_object(const AlignedTrack& track,
                                               const std::array<Eigen::Vector2d, 2>& x,
                                               double sigma_px) {
  std::vector<ViewedPoint> observations;
  for (std::size_t j = 0; j < 2; ++j) {
    const ConditionedView& view = track.lines.frames.of(track.line.observations[j]);
    observations.push_back({view.image_from_object, end_in_image(track.line.observations[j], x[j],
                                                                 sigma_px / view.image.scale_px)});
  }
  const auto estimated = estimate_point(observations);
  if (!estimated || !plausible(track.lines, track.line, estimated->point.mean)) return std::nullopt;
  return estimated->point;
}

TrackEvidence evidence_of(const AlignedTrack& track, std::span<const int> neighbours) {
  TrackEvidence evidence{track, {}, {}, {}, {}};
  for (const CandidatePoint& c : candidate_points(track.lines, track.line, neighbours)) {
    if (!(c.ranked.weight > kMinWeight)) continue;
    evidence.points.push_back(c);
    DepthEvidence e =
        evidence_of(c.estimated.point, c.ranked.parameter, kMaxPointPrior * c.ranked.weight);
    e.meeting = c.ranked.weight;
    e.may_cut = may_cut(track, c);
    evidence.on_depth.push_back(e);
  }
  for (const int which : {0, 1}) {
    if (const auto end = point_in_object(track, track.ends(which), kSigmaOfEnds_px)) {
      evidence.ends.push_back(*end);
      evidence.which_ends.push_back(which);
      evidence.on_depth.push_back(evidence_of(*end, which, kEndPrior));
    }
  }
  return evidence;
}

}  // namespace ridgeline::reconstruct
