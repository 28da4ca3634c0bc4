// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/line_support.h"

#include "reconstruct/estimate/depth_consensus.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

std::vector<CandidatePoint> best_of_regions(std::span<const CandidatePoint> candidates,
                                            const ReconstructOptions& options) {
  std::vector<RankedPoint> ranked;
  ranked.reserve(candidates.size());
  for (const CandidatePoint& candidate : candidates) ranked.push_back(candidate.ranked);
  std::vector<CandidatePoint> selected;
  for (const std::size_t i : select_points(ranked, options)) selected.push_back(candidates[i]);
  return selected;
}

/// A segment's end: uncertain along the line by sigma_end, across as the line is there.
UncertainPoint2 end_in_image(const ObservedLine& observed,
                             const Eigen::Vector2d& end,
                             double sigma_end) {
  const Eigen::Vector2d along = (observed.segment.end - observed.segment.start).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector3d x = end.homogeneous();
  const double norm = observed.line.mean.head<2>().norm();
  const double variance_across = x.dot(observed.line.cov * x) / (norm * norm);
  UncertainPoint2 point{x, Eigen::Matrix3d::Zero()};
  point.cov.topLeftCorner<2, 2>() = sigma_end * sigma_end * along * along.transpose() +
                                    variance_across * across * across.transpose();
  return spherically_normalised(point);
}

/// What the left camera sees at a pixel on the level of the patch's centre, seen by the right one.
Eigen::Vector2d on_level(const StereoViews& stereo, const Eigen::Vector2d& x_in_left) {
  const ProjectionMatrix& left = stereo.views[0].image_from_object;
  Eigen::Matrix3d image_from_level;  // of (X, Y, 1)
  image_from_level << left.col(0), left.col(1), left.col(3);
  const Eigen::Vector3d x = image_from_level.inverse() * x_in_left.homogeneous();
  return (stereo.views[1].image_from_object * Eigen::Vector4d(x.x(), x.y(), 0.0, x.z()))
      .hnormalized();
}

/// Whether the right segment runs the other way than the left one, by whatever rule the segments
/// were directed.
bool runs_back(const StereoLines& lines, int line) {
  const std::array<ObservedLine, 2>& observed = lines.lines[static_cast<std::size_t>(line)];
  const Segment2& left = observed[0].segment;
  const Segment2& right = observed[1].segment;
  const Eigen::Vector2d expected =
      on_level(lines.stereo, left.end) - on_level(lines.stereo, left.start);
  return expected.dot(right.end - right.start) < 0.0;
}

/// The point that the starts (0) or the ends (1) of both segments show; empty if none before the
/// cameras and within the heights.
std::optional<UncertainPoint3> end_in_object(const StereoLines& lines,
                                             int line,
                                             int which,
                                             const ReconstructOptions& options) {
  const bool back = runs_back(lines, line);
  std::vector<PointObservation> observations;
  for (std::size_t j = 0; j < 2; ++j) {
    const View& view = lines.stereo.views[j];
    const ObservedLine& observed = lines.lines[static_cast<std::size_t>(line)][j];
    const bool at_start = (which == 0) != (back && j == 1);
    const Eigen::Vector2d& end = at_start ? observed.segment.start : observed.segment.end;
    observations.push_back(
        {view.image_from_object,
         end_in_image(observed, end, options.sigma_end_px / view.image.scale_px)});
  }
  const auto estimated = estimate_point(observations);
  if (!estimated || !plausible(lines, estimated->point.mean, options)) return std::nullopt;
  return estimated->point;
}

DepthEvidence evidence_of(const UncertainPoint3& point, double parameter, double prior) {
  const Eigen::Matrix<double, 3, 4> jacobian = euclidean_jacobian(point.mean);
  return {point.mean.hnormalized(), jacobian * point.cov * jacobian.transpose(), parameter, prior};
}

/// Whether a segment is long enough for its ends to tell a depth.
bool has_telling_ends(const StereoLines& lines, int line, const ReconstructOptions& options) {
  const View& base = lines.stereo.views[0];
  const Segment2& segment = lines.lines[static_cast<std::size_t>(line)][0].segment;
  return base.image.scale_px * length(segment) >= options.min_ends_length_px;
}

/// Whether the points are far enough apart, as a share of the segment.
bool fix_direction(std::span<const CandidatePoint> points) {
  if (points.empty()) return false;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const CandidatePoint& a, const CandidatePoint& b) {
        return a.ranked.parameter < b.ranked.parameter;
      });
  return high->ranked.parameter - low->ranked.parameter >= kSmallestBase;
}

}  // namespace

LineSupport line_support(const StereoLines& lines,
                         int line,
                         std::span<const int> neighbours,
                         std::span<const double> heights_nearby,
                         const ReconstructOptions& options) {
  const std::vector<CandidatePoint> candidates = candidate_points(lines, line, neighbours, options);
  if (!options.consensus) return {best_of_regions(candidates, options), {}, std::nullopt};

  std::vector<DepthEvidence> evidence;
  std::vector<CandidatePoint> heard;
  for (const CandidatePoint& c : candidates) {
    if (!(c.ranked.weight > options.min_weight)) continue;
    heard.push_back(c);
    evidence.push_back(evidence_of(c.estimated.point, c.ranked.parameter,
                                   options.max_point_prior * c.ranked.weight));
    evidence.back().meeting = c.ranked.weight;
  }
  std::vector<UncertainPoint3> ends;
  for (const int which : {0, 1}) {
    if (const auto end = end_in_object(lines, line, which, options)) {
      ends.push_back(*end);
      evidence.push_back(evidence_of(*end, which, options.end_prior));
    }
  }
  const auto consensus = agree_on_depth(lines, line, evidence, heights_nearby, options);
  if (!consensus) return {};

  std::vector<CandidatePoint> agreeing;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    if (consensus->supports[i]) agreeing.push_back(heard[i]);
  }
  LineSupport support;
  support.points = best_of_regions(agreeing, options);
  support.ambiguous = consensus->margin < options.min_depth_margin ||
                      (support.points.empty() && !has_telling_ends(lines, line, options));
  if (consensus->horizontal) support.sigma_slope = options.sigma_slope;
  support.points_fix_direction = fix_direction(support.points);
  if (support.points_fix_direction) return support;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (consensus->supports[heard.size() + i]) support.ends.push_back({ends[i]});
  }
  return support;
}

}  // namespace ridgeline::reconstruct
