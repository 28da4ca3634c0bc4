// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/consensus_support.h"

#include "reconstruct/beyond/depth_consensus/depth_consensus.h"
#include "reconstruct/geometry/segment_index.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kMostPointPrior =
    0.7;                            ///< that two lines which cross in both images meet, at W = 1
constexpr double kEndPrior = 0.75;  ///< that the ends of both segments show the same point
constexpr double kLeastCutWeight = 0.3;  ///< W of the point where a match is cut
/// Lines that rest on their ends alone are at least this long: false matches of short segments have ends that agree as well.
constexpr double kShortestWithEnds_px = 15.0;

/// The ends of lines of known height, by their place in the left image.
class KnownEnds {
  static constexpr double kNearby_px = 100.0;  // from the line, in the base image
  static constexpr double kLargestSigma_m =
      0.4;  // of the height of a line that others are compared with

 public:
  KnownEnds(const StereoLines& lines, std::span<const ReconstructedLine> results) {
    for (const ReconstructedLine& line : results) {
      if (line.line_class == LineClass::kAligned || !line.segment_in_local) continue;
      if (*line.direct_sigma_z_m > kLargestSigma_m) continue;
      add(lines.stereo, line.segment_in_local->start);
      add(lines.stereo, line.segment_in_local->end);
    }
    index_ = SegmentIndex(ends_px_);
  }

  /// Heights of the ends near an image line, in the conditioned object frame.
  [[nodiscard]] std::vector<double> heights_near(const Segment2& seen_px) const {
    std::vector<double> heights;
    for (const int i : index_.near(seen_px, kNearby_px)) {
      const auto end = static_cast<std::size_t>(i);
      if (distance(seen_px, ends_px_[end].start) <= kNearby_px) heights.push_back(heights_[end]);
    }
    return heights;
  }

 private:
  /// The line may end where the right segment does: its place in the left image is the end's own.
  void add(const StereoViews& stereo, const Eigen::Vector3d& end_in_local) {
    const Eigen::Vector3d x = stereo.object.conditioned_from_local(end_in_local);
    const Eigen::Vector2d x_px =
        stereo.views[0].image.image_from_conditioned(project(stereo.views[0].image_from_object, x));
    ends_px_.push_back({x_px, x_px});
    heights_.push_back(x.z());
  }

  std::vector<Segment2> ends_px_;  ///< of no length
  std::vector<double> heights_;
  SegmentIndex index_{{}};
};

/// A segment's end: uncertain along the line by sigma_end, across as the line is there.
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

/// What the left camera sees at a pixel on the level of the patch's centre, seen by the right one.
Eigen::Vector2d on_level(const StereoViews& stereo, const Eigen::Vector2d& x_in_left) {
  const ProjectionMatrix& left = stereo.views[0].image_from_object;
  Eigen::Matrix3d image_from_level;  // of (X, Y, 1)
  image_from_level << left.col(0), left.col(1), left.col(3);
  const Eigen::Vector3d x = image_from_level.inverse() * x_in_left.homogeneous();
  return (stereo.views[1].image_from_object * Eigen::Vector4d(x.x(), x.y(), 0.0, x.z()))
      .hnormalized();
}

/// A match in the frames of the estimation.
struct Match {
  Match(const StereoLines& all, const ObservedPair& observed)
      : lines(all), line(observed), runs_back(is_reversed()) {}

  const StereoLines& lines;
  const ObservedPair& line;
  /// Whether the right segment runs the other way than the left one, by whatever rule the segments
  /// were directed.
  bool runs_back;

  /// The starts (0) or the ends (1) of both segments, in the direction of the left one.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> ends(int which) const {
    const auto end = [](const Segment2& s, bool at_start) { return at_start ? s.start : s.end; };
    return {end(line[0].segment, which == 0), end(line[1].segment, (which == 0) != runs_back)};
  }
  /// Where it crosses another match in both images.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> crossing_with(int other) const {
    return crossing(line, lines.lines[static_cast<std::size_t>(other)]);
  }

 private:
  [[nodiscard]] bool is_reversed() const {
    const Segment2& left = line[0].segment;
    const Eigen::Vector2d expected =
        on_level(lines.stereo, left.end) - on_level(lines.stereo, left.start);
    return expected.dot(line[1].segment.end - line[1].segment.start) < 0.0;
  }
};

/// What both images show at points of their segments; empty if not before the cameras and within the
/// heights.
/// @param sigma_px  along the line
std::optional<UncertainPoint3> point_in_object(const Match& match,
                                               const std::array<Eigen::Vector2d, 2>& x,
                                               double sigma_px) {
  std::vector<PointObservation> observations;
  for (std::size_t j = 0; j < 2; ++j) {
    const ConditionedView& view = match.lines.stereo.views[j];
    observations.push_back({view.image_from_object,
                            end_in_image(match.line[j], x[j], sigma_px / view.image.scale_px)});
  }
  const auto estimated = estimate_point(observations);
  if (!estimated || !plausible(match.lines, estimated->point.mean)) return std::nullopt;
  return estimated->point;
}

DepthEvidence evidence_of(const UncertainPoint3& point, double parameter, double prior) {
  const Eigen::Matrix<double, 3, 4> jacobian = euclidean_jacobian(point.mean);
  return {point.mean.hnormalized(), propagated(jacobian, point.cov), parameter, prior};
}

/// Whether a segment is long enough for its ends to tell a depth.
bool has_telling_ends(const Match& match) {
  return match.lines.stereo.views[0].image.scale_px * length(match.line[0].segment) >=
         kShortestWithEnds_px;
}

/// Whether the points are far enough apart, as a share of the segment.
bool fix_direction(std::span<const CandidatePoint> points) {
  if (points.empty()) return false;
  const auto [low, high] = std::ranges::minmax(
      transformed(points, [](const CandidatePoint& p) { return p.ranked.parameter; }));
  return high - low >= kSmallestBase;
}

/// Whether the match may be cut where it meets another one: the parts are long enough in both images.
bool may_cut(const Match& match, const CandidatePoint& at, const ConsensusOptions& options) {
  if (at.ranked.weight < kLeastCutWeight) return false;
  const auto x = match.crossing_with(at.ranked.neighbour);
  for (std::size_t j = 0; j < 2; ++j) {
    const double shortest = options.min_cut_length_px / match.lines.stereo.views[j].image.scale_px;
    const Segment2& segment = match.line[j].segment;
    const double to_end = std::min((x[j] - segment.start).norm(), (x[j] - segment.end).norm());
    if (!(distance(segment, x[j]) < 1e-9 && to_end >= shortest)) return false;
  }
  return true;
}

/// What tells the depth of a match: the artificial points that are good enough, and what its ends show.
struct MatchEvidence {
  Match match;
  std::vector<CandidatePoint> points;
  std::vector<UncertainPoint3> ends;
  std::vector<int> which_ends;          ///< 0 starts, 1 ends
  std::vector<DepthEvidence> on_depth;  ///< of the points, then of the ends
};

MatchEvidence evidence_of(const Match& match,
                          std::span<const int> neighbours,
                          const EstimationOptions& options) {
  MatchEvidence evidence{match, {}, {}, {}, {}};
  for (const CandidatePoint& c :
       candidate_points(match.lines, match.line, neighbours, options.lines)) {
    if (!(c.ranked.weight > options.lines.min_weight)) continue;
    evidence.points.push_back(c);
    DepthEvidence e =
        evidence_of(c.estimated.point, c.ranked.parameter, kMostPointPrior * c.ranked.weight);
    e.meeting = c.ranked.weight;
    e.may_cut = may_cut(match, c, options.consensus);
    evidence.on_depth.push_back(e);
  }
  for (const int which : {0, 1}) {
    if (const auto end =
            point_in_object(match, match.ends(which), options.consensus.sigma_end_px)) {
      evidence.ends.push_back(*end);
      evidence.which_ends.push_back(which);
      evidence.on_depth.push_back(evidence_of(*end, which, kEndPrior));
    }
  }
  return evidence;
}

/// The part of the match between the cuts.
ObservedPair seen_part(const MatchEvidence& evidence, const DepthPart& part) {
  const Match& match = evidence.match;
  ObservedPair seen = match.line;
  const auto cut = [&](std::size_t point, bool at_start) {
    const auto x = match.crossing_with(evidence.points[point].ranked.neighbour);
    for (std::size_t j = 0; j < 2; ++j) {
      const bool starts = at_start != (match.runs_back && j == 1);
      (starts ? seen[j].segment.start : seen[j].segment.end) = x[j];
    }
  };
  if (part.from) cut(*part.from, true);
  if (part.to) cut(*part.to, false);
  return seen;
}

/// Takes points of the line that lie on the surface beside it; false if it does not tell them.
bool add_surface_points(const Match& match,
                        const Surface& surface,
                        const DepthPart& part,
                        LineSupport& support) {
  const auto found = SurfaceDepth(surface, match.lines, support.seen).homologous(part.line);
  if (!found) return false;
  for (const SurfaceDepth::Homologous& h : *found) {
    if (const auto point = point_in_object(match, h.x, h.sigma_px)) {
      support.ends.push_back(*point);
      support.ends_in_images.push_back(h.x);
      support.sigma_ends_px = std::max(support.sigma_ends_px, h.sigma_px);
    }
  }
  support.on_surface = !support.ends.empty();
  return support.on_surface;
}

/// A point where a line misses this one by a standard deviation, in any direction.
UncertainPoint3 scattered(UncertainPoint3 point, double sigma) {
  const double w = point.mean.w();
  point.cov.topLeftCorner<3, 3>() += w * w * sigma * sigma * Eigen::Matrix3d::Identity();
  return spherically_normalised(point);
}

LineSupport support_of(const MatchEvidence& evidence,
                       const DepthPart& part,
                       const Surface* surface,
                       const EstimationOptions& options) {
  LineSupport support;
  support.seen = seen_part(evidence, part);
  std::vector<CandidatePoint> agreeing;
  for (const std::size_t i : part.supports) {
    if (i >= evidence.points.size()) continue;
    agreeing.push_back(evidence.points[i]);
    UncertainPoint3& point = agreeing.back().estimated.point;
    point = scattered(
        point, options.building.sigma_meeting_m / evidence.match.lines.stereo.object.scale_m);
    RankedPoint& ranked = agreeing.back().ranked;
    const auto x = evidence.match.crossing_with(ranked.neighbour);
    ranked.parameter = parameter_along(support.seen[0].segment, x[0]);
  }
  support.points = best_of_regions(agreeing, options.lines);
  if (part.horizontal) support.sigma_slope = options.building.sigma_slope;
  support.points_fix_direction = fix_direction(support.points);
  if (surface != nullptr && add_surface_points(evidence.match, *surface, part, support))
    return support;
  if (support.points_fix_direction) return support;
  for (const std::size_t i : part.supports) {
    if (i < evidence.points.size()) continue;
    const std::size_t end = i - evidence.points.size();
    support.ends.push_back(evidence.ends[end]);
    support.sigma_ends_px = options.consensus.sigma_end_px;
    support.ends_in_images.push_back(evidence.match.ends(evidence.which_ends[end]));
  }
  const bool is_cut = part.from || part.to;
  if (support.points.empty()) {
    support.ambiguous = is_cut || support.ends.empty() || !has_telling_ends(evidence.match);
  } else {
    support.ambiguous = is_cut && !part.horizontal && support.ends.empty();
  }
  return support;
}

std::vector<LineSupport> lines_by_consensus(const Match& match,
                                            std::span<const int> neighbours,
                                            std::span<const double> heights_nearby,
                                            const Surface* surface,
                                            const EstimationOptions& options) {
  const MatchEvidence evidence = evidence_of(match, neighbours, options);
  std::optional<SurfaceDepth> depth;
  if (surface != nullptr) depth.emplace(*surface, match.lines, match.line);
  const auto consensus =
      agree_on_depth({match.lines, match.line, evidence.on_depth, heights_nearby, options.consensus,
                      options.building, depth ? &*depth : nullptr});
  if (!consensus) return {LineSupport{.seen = match.line}};
  std::vector<LineSupport> all;
  for (const DepthPart& part : consensus->parts) {
    all.push_back(support_of(evidence, part, surface, options));
    if (consensus->margin < options.consensus.min_depth_margin) all.back().ambiguous = true;
  }
  return all;
}

}  // namespace

SupportOfMatch consensus_support(const StereoLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 const Surface* surface,
                                 const EstimationOptions& options) {
  return [&lines, surface, options, ends = KnownEnds(lines, direct)](
             const ObservedPair& line, std::span<const int> neighbours) {
    const ImageConditioning& image = lines.stereo.views[0].image;
    const Segment2 seen_px{image.image_from_conditioned(line[0].segment.start),
                           image.image_from_conditioned(line[0].segment.end)};
    return lines_by_consensus({lines, line}, neighbours, ends.heights_near(seen_px), surface,
                              options);
  };
}

}  // namespace ridgeline::reconstruct
