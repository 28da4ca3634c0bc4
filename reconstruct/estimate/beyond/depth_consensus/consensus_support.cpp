// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/consensus_support.h"

#include "reconstruct/estimate/beyond/depth_consensus/depth_consensus.h"
#include "reconstruct/estimate/beyond/depth_consensus/known_ends.h"
#include "reconstruct/estimate/beyond/depth_consensus/match_evidence.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

/// Lines supported by their ends alone must be at least this long, because the ends of falsely
/// matched short segments can agree as well.
constexpr double kMinLengthWithEnds_px = 15.0;

/// Whether a segment is long enough for its ends to determine a depth.
bool has_telling_ends(const AlignedTrack& track) {
  return track.lines.frames.of(track.line.base()).image.scale_px *
             length(track.line.base().segment) >=
         kMinLengthWithEnds_px;
}

/// Whether the points are far enough apart along the segment to determine its direction.
bool fix_direction(std::span<const CandidatePoint> points) {
  if (points.empty()) return false;
  const auto [low, high] = std::ranges::minmax(
      transformed(points, [](const CandidatePoint& p) { return p.ranked.parameter; }));
  return high - low >= kMinBase;
}

/// The part of the track between the cuts.
ObservedTrack part_of(const TrackEvidence& evidence, const DepthPart& part) {
  const AlignedTrack& track = evidence.track;
  ObservedTrack part_of_track = track.line;
  const auto cut = [&](std::size_t point, bool at_start) {
    const auto x = track.places_of(evidence.points[point]);
    for (std::size_t j = 0; j < 2; ++j) {
      const bool starts = at_start != (track.runs_back && j == 1);
      Segment2& segment = part_of_track.observations[j].segment;
      (starts ? segment.start : segment.end) = x[j];
    }
  };
  if (part.from) cut(*part.from, true);
  if (part.to) cut(*part.to, false);
  return part_of_track;
}

/// Adds points of the line that lie on the surface beside it. Returns false if the surface gives
/// none.
bool add_surface_points(const AlignedTrack& track,
                        const Surface& surface,
                        const DepthPart& part,
                        LineSupport& support) {
  const auto found = SurfaceDepth(surface, track.lines, support.track).homologous(part.line);
  if (!found) return false;
  for (const SurfaceDepth::Homologous& h : *found) {
    if (const auto point = point_in_object(track, h.x, h.sigma_px)) {
      support.ends.push_back(*point);
      support.ends_in_images.push_back(h.x);
      support.sigma_ends_px = std::max(support.sigma_ends_px, h.sigma_px);
    }
  }
  support.on_surface = !support.ends.empty();
  return support.on_surface;
}

/// The point with `sigma` added to its uncertainty in every direction, because lines that meet miss
/// each other by this much.
UncertainPoint3 scattered(UncertainPoint3 point, double sigma) {
  const double w = point.mean.w();
  point.cov.topLeftCorner<3, 3>() += w * w * sigma * sigma * Eigen::Matrix3d::Identity();
  return spherically_normalised(point);
}

LineSupport support_of(const TrackEvidence& evidence,
                       const DepthPart& part,
                       const Surface* surface,
                       const EstimationOptions& options) {
  LineSupport support;
  support.track = part_of(evidence, part);
  std::vector<CandidatePoint> agreeing;
  for (const std::size_t i : part.supports) {
    if (i >= evidence.points.size()) continue;
    agreeing.push_back(evidence.points[i]);
    UncertainPoint3& point = agreeing.back().estimated.point;
    point = scattered(
        point, options.building.sigma_meeting_m / evidence.track.lines.frames.object.scale_m);
    RankedPoint& ranked = agreeing.back().ranked;
    const auto x = evidence.track.places_of(evidence.points[i]);
    ranked.parameter = parameter_along(support.track.base().segment, x[0]);
  }
  support.points = best_of_regions(agreeing);
  if (part.horizontal) support.sigma_slope = options.building.sigma_slope;
  support.points_fix_direction = fix_direction(support.points);
  if (surface != nullptr && add_surface_points(evidence.track, *surface, part, support))
    return support;
  if (support.points_fix_direction) return support;
  for (const std::size_t i : part.supports) {
    if (i < evidence.points.size()) continue;
    const std::size_t end = i - evidence.points.size();
    support.ends.push_back(evidence.ends[end]);
    support.sigma_ends_px = kSigmaOfEnds_px;
    support.ends_in_images.push_back(evidence.track.ends(evidence.which_ends[end]));
  }
  const bool is_cut = part.from || part.to;
  if (support.points.empty()) {
    support.ambiguous = is_cut || support.ends.empty() || !has_telling_ends(evidence.track);
  } else {
    support.ambiguous = is_cut && !part.horizontal && support.ends.empty();
  }
  return support;
}

std::vector<LineSupport> lines_by_consensus(const AlignedTrack& track,
                                            std::span<const int> neighbours,
                                            std::span<const double> heights_nearby,
                                            const Surface* surface,
                                            const EstimationOptions& options) {
  const TrackEvidence evidence = evidence_of(track, neighbours);
  std::optional<SurfaceDepth> depth;
  if (surface != nullptr) depth.emplace(*surface, track.lines, track.line);
  const auto consensus =
      agree_on_depth({track.lines, track.line, evidence.on_depth, heights_nearby, options.consensus,
                      options.building, depth ? &*depth : nullptr});
  if (!consensus) return {LineSupport{.track = track.line}};
  std::vector<LineSupport> all;
  for (const DepthPart& part : consensus->parts) {
    all.push_back(support_of(evidence, part, surface, options));
    if (consensus->margin < options.consensus.min_depth_margin) all.back().ambiguous = true;
  }
  return all;
}

}  // namespace

SupportOfTrack consensus_support(const TrackedLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 const SurfaceOf& surface_of,
                                 const EstimationOptions& options) {
  return [&lines, surface_of, options, ends = KnownEnds(lines, direct)](
             const ObservedTrack& line, std::span<const int> neighbours) {
    const ImageConditioning& image = lines.frames.of(line.base()).image;
    const Segment2 seen_px{image.image_from_conditioned(line.base().segment.start),
                           image.image_from_conditioned(line.base().segment.end)};
    return lines_by_consensus({lines, line}, neighbours,
                              ends.heights_near(line.base().view, seen_px),
                              surface_of(line.base().view, line.other().view), options);
  };
}

}  // namespace ridgeline::reconstruct
