// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/ok2011/estimate/adjust_line.h"
#include "reconstruct/ok2011/estimate/line_geometry.h"
#include "reconstruct/ok2011/estimate/line_support.h"
#include "reconstruct/views/stereo_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

void classify(const StereoLines& lines,
              std::size_t line,
              const ReconstructOptions& options,
              ReconstructedLine& result) {
  const std::array<ConditionedView, 2>& views = lines.stereo.views;
  for (std::size_t j = 0; j < 2; ++j) {
    result.epipolar_angles_rad[j] = epipolar_angle_rad(
        views[j].image_from_object, views[1 - j].image_from_object, lines.lines[line][j].segment);
  }
  result.epipolar_angle_rad =
      std::min(result.epipolar_angles_rad[0], result.epipolar_angles_rad[1]);
  const bool aligned =
      result.epipolar_angle_rad * 180.0 / std::numbers::pi <= options.max_aligned_angle_deg;
  result.line_class = aligned ? LineClass::kAligned : LineClass::kNotAligned;
}

Segment2 in_image(const ConditionedView& view, const ObservedLine& observed) {
  return {view.image.image_from_conditioned(observed.segment.start),
          view.image.image_from_conditioned(observed.segment.end)};
}

void reconstruct_direct(const StereoLines& lines,
                        const ObservedPair& line,
                        double max_end_sigma_m,
                        ReconstructedLine& result) {
  for (std::size_t j = 0; j < 2; ++j) {
    result.seen_px[j] = in_image(lines.stereo.views[j], line[j]);
  }
  const auto estimate = intersection(line[0].plane, line[1].plane);
  if (!estimate || !assign_geometry(lines.stereo, line, *estimate, max_end_sigma_m, result)) return;
  result.status = Status::kDirect;
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

Status joint_status(const AdjustedLine& adjusted, const LineSupport& support) {
  if (!adjusted.full_rank) return Status::kRankDeficient;
  if (!adjusted.converged) return Status::kNotConverged;
  if (support.on_surface && !support.points_fix_direction) return Status::kSurface;
  if (support.sigma_slope && !support.points_fix_direction) return Status::kHorizontal;
  if (!support.ends.empty() && !support.on_surface) return Status::kSegmentEnds;
  return support.points.size() >= 2 ? Status::kJoint : Status::kOnePoint;
}

void give_up(Status why, ReconstructedLine& result) {
  result.status = why;
  result.segment_in_local.reset();
  result.covariance_m2.reset();
  result.right_segment_in_local.reset();
}

/// `result` comes with the line by the method `direct`. The line is replaced if there are points or ends to
/// adjust it to. It loses its geometry if its depth is ambiguous or the adjustment fails.
void reconstruct_joint(const StereoLines& lines,
                       const LineSupport& support,
                       double max_end_sigma_m,
                       ReconstructedLine& result) {
  if (support.ambiguous) return give_up(Status::kAmbiguousDepth, result);
  if (support.points.empty() && support.ends.empty()) {
    if (result.segment_in_local) result.status = Status::kNoPoints;
    return;
  }
  std::vector<UncertainPoint3> points = support.ends;
  for (const CandidatePoint& p : support.points) {
    points.push_back(p.estimated.point);
    result.points.push_back(used_point(p, lines.stereo.object));
  }
  const std::array<UncertainPlane3, 2> planes{support.seen[0].plane, support.seen[1].plane};
  const auto adjusted = adjust_line(planes, points, support.sigma_slope);
  if (!adjusted ||
      !assign_geometry(lines.stereo, support.seen, adjusted->line, max_end_sigma_m, result)) {
    return give_up(Status::kNoIntersection, result);
  }
  result.status = joint_status(*adjusted, support);
  result.omega = adjusted->omega;
  if (!adjusted->full_rank) result.covariance_m2.reset();
}

/// The lines of an aligned match by the method `joint`. `direct` is its one line by the method `direct`.
std::vector<JointLine> reconstruct_aligned(const StereoLines& lines,
                                           const std::vector<LineSupport>& parts,
                                           double max_end_sigma_m,
                                           const ReconstructedLine& direct) {
  std::vector<JointLine> results;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    JointLine& result = results.emplace_back(JointLine{direct, parts[p]});
    if (parts.size() > 1) {
      result.line.part = static_cast<int>(p) + 1;
      reconstruct_direct(lines, parts[p].seen, max_end_sigma_m, result.line);
    }
    reconstruct_joint(lines, parts[p], max_end_sigma_m, result.line);
  }
  return results;
}

std::vector<ReconstructedLine> direct_lines(const StereoLines& lines,
                                            std::span<const ObservedPair> observed,
                                            std::span<const LineMatch> matches,
                                            const ReconstructOptions& options,
                                            double max_end_sigma_m) {
  std::vector<ReconstructedLine> results(matches.size());
  tbb::parallel_for(std::size_t{0}, matches.size(), [&](std::size_t i) {
    ReconstructedLine& result = results[i];
    result.match = matches[i];
    classify(lines, i, options, result);
    reconstruct_direct(lines, observed[i], max_end_sigma_m, result);
  });
  return results;
}

/// The lines of each match by the method `joint`.
/// @param support  gives the support of aligned lines
/// @param direct   the lines of the matches by the method `direct`
std::vector<std::vector<JointLine>> joint_lines(const StereoLines& lines,
                                                std::span<const ObservedPair> observed,
                                                const Neighbours& neighbours,
                                                const SupportOfMatch& support,
                                                std::span<const ReconstructedLine> direct,
                                                double max_end_sigma_m) {
  std::vector<std::vector<JointLine>> by_match(observed.size());
  tbb::parallel_for(std::size_t{0}, observed.size(), [&](std::size_t i) {
    Interruption::check();
    if (direct[i].line_class != LineClass::kAligned) {
      // A line that is not aligned rests on the images alone.
      by_match[i] = {{direct[i], LineSupport{.seen = observed[i]}}};
      return;
    }
    const std::vector<LineSupport> parts = support(observed[i], neighbours[i]);
    by_match[i] = reconstruct_aligned(lines, parts, max_end_sigma_m, direct[i]);
  });
  return by_match;
}

std::vector<ReconstructedLine> flattened(const std::vector<std::vector<JointLine>>& by_match) {
  std::vector<ReconstructedLine> all;
  for (const std::vector<JointLine>& lines : by_match) {
    for (const JointLine& joint : lines) all.push_back(joint.line);
  }
  return all;
}

void check_input(const MatchedSegments& matched,
                 const ReconstructOptions& options,
                 const EstimateExtensions& beyond) {
  check(matched.cameras.size() == 2, "reconstruct_lines: cameras = ", matched.cameras.size(),
        ", must be 2");
  check(matched.segments.size() == 2, "reconstruct_lines: images = ", matched.segments.size(),
        ", must be 2");
  const std::size_t n_registrations = matched.registrations.size();
  check(n_registrations == 0 || n_registrations == matched.matches.size(),
        "reconstruct_lines: registrations = ", n_registrations, ", must be one per match, ",
        matched.matches.size(), ", or none");
  for (const Registration& r : matched.registrations) {
    check(std::isfinite(r.right_shift_px), "reconstruct_lines: right_shift_px = ", r.right_shift_px,
          ", must be finite");
    check(r.sigma_scale > 0.0 && std::isfinite(r.sigma_scale),
          "reconstruct_lines: sigma_scale = ", r.sigma_scale, ", must be positive");
  }
  validate(options);
  check(options.method != Method::kPlanes,
        "reconstruct_lines: method = planes, which takes no matches; see plane_lines()");
  check(options.method != Method::kNetwork || beyond.network,
        "reconstruct_lines: method = network, which goes beyond the paper and needs its extension");
}

}  // namespace

const char* name(Method method) {
  constexpr std::array kNames{"planes", "direct", "joint", "network"};
  return kNames.at(static_cast<std::size_t>(method));
}

const char* name(LineClass line_class) {
  return line_class == LineClass::kAligned ? "aligned" : "not_aligned";
}

const char* name(Status status) {
  constexpr std::array kNames{
      "direct",          "joint",     "one_point",      "surface",       "segment_ends",
      "horizontal",      "no_points", "rank_deficient", "not_converged", "ambiguous_depth",
      "no_intersection", "network",   "planes"};
  return kNames.at(static_cast<std::size_t>(status));
}

std::vector<ReconstructedLine> reconstruct_lines(const MatchedSegments& matched,
                                                 const ReconstructOptions& options,
                                                 const EstimateExtensions& beyond) {
  check_input(matched, options, beyond);
  const std::span<const LineMatch> matches = matched.matches;
  const Neighbours neighbours = neighbours_of(matched.connections, matches.size());
  if (matches.empty()) return {};
  // The consensus on the depth of aligned lines uses the lines that these meet as they were extracted, not as registered.
  const StereoLines lines =
      stereo_lines(matched, extracted_mates(matched), options.line_covariance);
  const std::vector<Mates> registered = registered_mates(matched);
  const std::vector<ObservedPair> observed =
      stereo_lines(matched, registered, options.line_covariance).lines;

  std::vector<ReconstructedLine> direct =
      direct_lines(lines, observed, matches, options, beyond.max_end_sigma_m);
  if (options.method == Method::kDirect) return direct;

  SupportOfMatch support = [&](const ObservedPair& line, std::span<const int> mates) {
    return std::vector{published_support(lines, line, mates, options)};
  };
  if (beyond.support) {
    support = beyond.support(
        lines, direct_lines(lines, lines.lines, matches, options, beyond.max_end_sigma_m));
  }
  std::vector<std::vector<JointLine>> by_match =
      joint_lines(lines, observed, neighbours, support, direct, beyond.max_end_sigma_m);
  if (options.method == Method::kNetwork) {
    beyond.network(stereo_lines(matched, registered, LineCovariance::kCentroid),
                   matched.connections, by_match);
  }
  return flattened(by_match);
}

}  // namespace ridgeline::reconstruct
