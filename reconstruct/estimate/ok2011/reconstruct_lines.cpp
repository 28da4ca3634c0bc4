// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"

#include "reconstruct/estimate/ok2011/adjust_line.h"
#include "reconstruct/estimate/ok2011/line_geometry.h"
#include "reconstruct/estimate/ok2011/line_support.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ridgeline::reconstruct {
namespace {

/// The largest epipolar angle over all pairs of views; for each pair, the smaller angle of the two
/// images.
double epipolar_angle_rad(const ConditionedViews& frames, const ObservedTrack& track) {
  const std::vector<ObservedLine>& lines = track.observations;
  double largest = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      if (lines[i].view == lines[k].view) continue;
      const std::array cameras{frames.of(lines[i]).image_from_object,
                               frames.of(lines[k]).image_from_object};
      largest = std::max(
          largest, ridgeline::epipolar_angle_rad(cameras, lines[i].segment, lines[k].segment));
    }
  }
  return largest;
}

void classify(const TrackedLines& lines,
              std::size_t line,
              const ReconstructOptions& options,
              ReconstructedLine& result) {
  result.epipolar_angle_rad = epipolar_angle_rad(lines.frames, lines.lines[line]);
  const bool aligned = deg_from_rad(result.epipolar_angle_rad) <= options.max_aligned_angle_deg;
  result.line_class = aligned ? LineClass::kAligned : LineClass::kNotAligned;
}

Segment2 in_image(const ConditionedView& view, const ObservedLine& observed) {
  return {view.image.image_from_conditioned(observed.segment.start),
          view.image.image_from_conditioned(observed.segment.end)};
}

std::vector<UncertainPlane3> planes_of(const ObservedTrack& line) {
  return transformed(line.observations, &ObservedLine::plane);
}

/// The line in the projection planes. Two planes are intersected; more are adjusted.
std::optional<UncertainLine3> line_of_planes(const ObservedTrack& line) {
  if (line.observations.size() == 2) return intersection(line.base().plane, line.other().plane);
  const auto adjusted = adjust_line(planes_of(line), {});
  if (!adjusted || !adjusted->full_rank) return std::nullopt;
  return adjusted->line;
}

void reconstruct_direct(const TrackedLines& lines,
                        const ObservedTrack& line,
                        ReconstructedLine& result) {
  for (std::size_t j = 0; j < line.observations.size(); ++j) {
    const ObservedLine& observed = line.observations[j];
    result.observations[j].px = in_image(lines.frames.of(observed), observed);
  }
  const auto estimate = line_of_planes(line);
  if (!estimate || !assign_geometry(lines, line, *estimate, result)) return;
  result.determination = Determination::kDirect;
  result.failure.reset();
  result.direct_sigma_z_m = largest_sigma_z_m(*result.covariance_m2);
}

UsedPoint used_point(const CandidatePoint& candidate, const ObjectConditioning& object) {
  const UncertainPoint3& point = candidate.estimated.point;
  const Eigen::Matrix<double, 3, 4> jacobian = object.scale_m * euclidean_jacobian(point.mean);
  const RankedPoint& ranked = candidate.ranked;
  return {.x_in_local = object.local_from_conditioned(point.mean.hnormalized()),
          .cov_m2 = propagated(jacobian, point.cov),
          .neighbour = ranked.neighbour,
          .weight = ranked.weight,
          .omega = ranked.omega,
          .region = region(ranked.parameter)};
}

Determination joint_determination(const AdjustedLine& adjusted, const LineSupport& support) {
  if (!adjusted.full_rank) return Determination::kRankDeficient;
  if (!adjusted.converged) return Determination::kNotConverged;
  if (support.on_surface && !support.points_fix_direction) return Determination::kSurface;
  if (support.sigma_slope && !support.points_fix_direction) return Determination::kHorizontal;
  if (!support.ends.empty() && !support.on_surface) return Determination::kSegmentEnds;
  return support.points.size() >= 2 ? Determination::kJoint : Determination::kOnePoint;
}

void give_up(Failure why, ReconstructedLine& result) {
  result.failure = why;
  result.segment_in_local.reset();
  result.covariance_m2.reset();
  result.other_segment_in_local.reset();
}

/// `result` initially holds the line by the method `direct`. The line is replaced if there are
/// points or ends to adjust it to. It loses its geometry if its depth is ambiguous or the
/// adjustment fails.
void reconstruct_joint(const TrackedLines& lines,
                       const LineSupport& support,
                       ReconstructedLine& result) {
  if (support.ambiguous) return give_up(Failure::kAmbiguousDepth, result);
  if (support.points.empty() && support.ends.empty()) {
    if (result.segment_in_local) result.determination = Determination::kNoPoints;
    return;
  }
  std::vector<UncertainPoint3> points = support.ends;
  for (const CandidatePoint& p : support.points) {
    points.push_back(p.estimated.point);
    result.points.push_back(used_point(p, lines.frames.object));
  }
  const auto adjusted = adjust_line(planes_of(support.track), points, support.sigma_slope);
  if (!adjusted || !assign_geometry(lines, support.track, adjusted->line, result)) {
    return give_up(Failure::kNoIntersection, result);
  }
  result.determination = joint_determination(*adjusted, support);
  result.failure.reset();
  result.omega = adjusted->omega;
  if (!adjusted->full_rank) result.covariance_m2.reset();
}

/// The lines of an aligned track by the method `joint`. `direct` is its single line by the method
/// `direct`.
std::vector<JointLine> reconstruct_aligned(const TrackedLines& lines,
                                           const std::vector<LineSupport>& parts,
                                           const ReconstructedLine& direct) {
  std::vector<JointLine> results;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    JointLine& result = results.emplace_back(JointLine{direct, parts[p]});
    if (parts.size() > 1) {
      result.line.part = static_cast<int>(p) + 1;
      reconstruct_direct(lines, parts[p].track, result.line);
    }
    reconstruct_joint(lines, parts[p], result.line);
  }
  return results;
}

std::vector<ReconstructedLine> direct_lines(const TrackedLines& lines,
                                            std::span<const ObservedTrack> observed,
                                            std::span<const Track> tracks,
                                            const ReconstructOptions& options) {
  std::vector<ReconstructedLine> results(tracks.size());
  tbb::parallel_for(std::size_t{0}, tracks.size(), [&](std::size_t i) {
    ReconstructedLine& result = results[i];
    result.observations = transformed(tracks[i].observations, [](const Observation& s) {
      return ObservedSegment{s, {}};
    });
    classify(lines, i, options, result);
    reconstruct_direct(lines, observed[i], result);
  });
  return results;
}

/// The lines of each track by the method `joint`.
/// @param support  gives the support of aligned lines
/// @param direct   the lines of the tracks by the method `direct`
std::vector<std::vector<JointLine>> joint_lines(const TrackedLines& lines,
                                                std::span<const ObservedTrack> observed,
                                                const Neighbours& neighbours,
                                                const SupportOfTrack& support,
                                                std::span<const ReconstructedLine> direct) {
  std::vector<std::vector<JointLine>> by_track(observed.size());
  tbb::parallel_for(std::size_t{0}, observed.size(), [&](std::size_t i) {
    Interruption::check();
    if (direct[i].line_class != LineClass::kAligned) {
      // A line that is not aligned depends on the images alone.
      by_track[i] = {{direct[i], LineSupport{.track = observed[i]}}};
      return;
    }
    const std::vector<LineSupport> parts = support(observed[i], neighbours[i]);
    by_track[i] = reconstruct_aligned(lines, parts, direct[i]);
  });
  return by_track;
}

std::vector<ReconstructedLine> flattened(const std::vector<std::vector<JointLine>>& by_track) {
  std::vector<ReconstructedLine> all;
  for (const std::vector<JointLine>& lines : by_track) {
    for (const JointLine& joint : lines) all.push_back(joint.line);
  }
  return all;
}

void check_input(const TrackedSegments& tracked,
                 const ReconstructOptions& options,
                 const EstimateExtensions& beyond) {
  check(tracked.cameras.size() >= 2, "reconstruct_lines: cameras = ", tracked.cameras.size(),
        ", must be 2 or more");
  check(tracked.segments.size() == tracked.cameras.size(),
        "reconstruct_lines: images = ", tracked.segments.size(), ", must be one per camera, ",
        tracked.cameras.size());
  const std::size_t n_registrations = tracked.registrations.size();
  check(n_registrations == 0 || n_registrations == tracked.tracks.size(),
        "reconstruct_lines: registrations = ", n_registrations, ", must be one per track, ",
        tracked.tracks.size(), ", or none");
  for (std::size_t i = 0; i < n_registrations; ++i) {
    check(tracked.registrations[i].size() == tracked.tracks[i].observations.size(),
          "reconstruct_lines: registrations of a track = ", tracked.registrations[i].size(),
          ", must be one per observation, ", tracked.tracks[i].observations.size());
    for (const Registration& r : tracked.registrations[i]) {
      check(std::isfinite(r.shift_px), "reconstruct_lines: shift_px = ", r.shift_px,
            ", must be finite");
      check(r.sigma_scale > 0.0 && std::isfinite(r.sigma_scale),
            "reconstruct_lines: sigma_scale = ", r.sigma_scale, ", must be positive");
    }
  }
  validate(options);
  check(!has_lines_of_planes(options.method), "reconstruct_lines: method = ", name(options.method),
        ", whose lines do not only come from tracks; see plane_lines()");
  check(options.method != Method::kNetwork || beyond.network,
        "reconstruct_lines: method = network, which is not a method of the paper");
}

}  // namespace

const char* name(Method method) {
  constexpr std::array kNames{"planes", "direct", "joint", "network", "lines"};
  return kNames.at(static_cast<std::size_t>(method));
}

const char* name(LineClass line_class) {
  return line_class == LineClass::kAligned ? "aligned" : "not_aligned";
}

const char* status_name(const ReconstructedLine& line) {
  constexpr std::array kFailures{"ambiguous_depth", "no_intersection"};
  constexpr std::array kDeterminations{"direct",        "joint",      "one_point", "surface",
                                       "segment_ends",  "horizontal", "no_points", "rank_deficient",
                                       "not_converged", "network",    "planes"};
  if (line.failure) return kFailures.at(static_cast<std::size_t>(*line.failure));
  if (!line.confirmed) return "unconfirmed";
  return kDeterminations.at(static_cast<std::size_t>(line.determination));
}

std::vector<ReconstructedLine> reconstruct_lines(const TrackedSegments& tracked,
                                                 const ReconstructOptions& options,
                                                 const EstimateExtensions& beyond) {
  check_input(tracked, options, beyond);
  const std::span<const Track> tracks = tracked.tracks;
  const Neighbours neighbours = neighbours_of(tracked.connections, tracks.size());
  if (tracks.empty()) return {};
  const auto lines_of = [&](const std::vector<TrackSegments>& segments, LineCovariance form) {
    TrackedLines lines = tracked_lines(tracked, segments, form);
    lines.common_part = beyond.common_part;
    return lines;
  };
  // The consensus on the depth of aligned lines uses the lines that they meet as extracted, not as
  // registered.
  const TrackedLines lines = lines_of(extracted(tracked), options.line_covariance);
  const std::vector<TrackSegments> corrected = registered(tracked);
  const std::vector<ObservedTrack> observed = lines_of(corrected, options.line_covariance).lines;

  std::vector<ReconstructedLine> direct = direct_lines(lines, observed, tracks, options);
  if (options.method == Method::kDirect) return direct;

  SupportOfTrack support = [&](const ObservedTrack& line, std::span<const int> counterparts) {
    return std::vector{published_support(lines, line, counterparts)};
  };
  if (beyond.support) {
    support = beyond.support(lines, direct_lines(lines, lines.lines, tracks, options));
  }
  std::vector<std::vector<JointLine>> by_track =
      joint_lines(lines, observed, neighbours, support, direct);
  if (options.method == Method::kNetwork) {
    beyond.network(lines_of(corrected, LineCovariance::kCentroid), tracked.connections, by_track);
  }
  return flattened(by_track);
}

}  // namespace ridgeline::reconstruct
