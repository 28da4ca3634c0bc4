// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/network_lines.h"

#include "reconstruct/estimate/beyond/network/junction.h"
#include "reconstruct/estimate/beyond/network/network.h"
#include "reconstruct/estimate/ok2011/line_geometry.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Starts from the line through both ends. The scatter of the ends along the line cancels out of
/// its covariance.
void start_from(const ReconstructedLine& joint,
                const ObjectConditioning& object,
                NetworkLine& line) {
  const Eigen::Vector4d start =
      object.conditioned_from_local(joint.segment_in_local->start).homogeneous();
  const Eigen::Vector4d end =
      object.conditioned_from_local(joint.segment_in_local->end).homogeneous();
  UncertainLine3 joined{pi_matrix(start) * end, Matrix6d::Zero()};
  if (joint.covariance_m2) {
    Matrix6d by_ends;  // Pi(X) Y = -Pi(Y) X
    by_ends << -pi_matrix(end).leftCols<3>(), pi_matrix(start).leftCols<3>();
    by_ends /= object.scale_m;
    joined.cov = propagated(by_ends, *joint.covariance_m2);
    joined = spherically_normalised(joined);
    line.start_cov = joined.cov;
  }
  line.start = project_to_pluecker_quadric(joined.mean.normalized());
}

NetworkLine network_line(const TrackedLines& lines, std::size_t track, const JointLine& joint) {
  NetworkLine line;
  line.track = lines.lines[track];
  for (std::size_t j = 0; j < line.track.observations.size(); ++j)
    line.track.observations[j].segment = joint.support.track.observations[j].segment;
  start_from(joint.line, lines.frames.object, line);
  line.is_horizontal = joint.support.sigma_slope.has_value();
  line.ends = joint.support.ends_in_images;
  line.sigma_ends_px = joint.support.sigma_ends_px;
  return line;
}

/// The lines with a geometry, and the tracks from which they come.
struct Members {
  std::vector<NetworkLine> lines;
  std::vector<JointLine*> results;
  std::vector<std::vector<int>> of_track;
};

Members members_of(const TrackedLines& lines, std::vector<std::vector<JointLine>>& by_track) {
  Members members;
  members.of_track.resize(by_track.size());
  for (std::size_t track = 0; track < by_track.size(); ++track) {
    for (JointLine& joint : by_track[track]) {
      if (!joint.line.segment_in_local) continue;
      members.of_track[track].push_back(static_cast<int>(members.lines.size()));
      members.lines.push_back(network_line(lines, track, joint));
      members.results.push_back(&joint);
    }
  }
  return members;
}

/// The part of a track that is closest to another line in the first view that shows both; empty for
/// a track without parts.
std::optional<int> closest_part(const Members& members,
                                std::size_t track,
                                const ObservedTrack& other) {
  const std::vector<int>& parts = members.of_track[track];
  const auto closest = std::ranges::min_element(parts, {}, [&](int part) {
    const SeenTogether both =
        seen_together(members.lines[static_cast<std::size_t>(part)].track, other).front();
    return distance(both.line.segment, both.other.segment);
  });
  return closest == parts.end() ? std::nullopt : std::optional(*closest);
}

std::vector<Meeting> meetings_of(const TrackedLines& lines,
                                 std::span<const PairConnection> connections,
                                 const Members& members,
                                 double sigma_meeting_m) {
  std::set<std::pair<int, int>> pairs;  // smaller index first, each pair once
  for (const PairConnection& c : connections) pairs.insert(std::minmax(c.i, c.k));
  std::vector<Meeting> meetings;
  for (const auto& [i, k] : pairs) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(k);
    if (!(pair_weight(lines, lines.lines[a], k) > kMinWeight)) continue;
    const auto first = closest_part(members, a, lines.lines[b]);
    const auto second = closest_part(members, b, lines.lines[a]);
    if (!first || !second) continue;
    meetings.push_back({*first, *second,
                        junction(lines.frames, members.lines[*first].track,
                                 members.lines[*second].track, sigma_meeting_m)});
  }
  return meetings;
}

/// Whether the line is determined far better than by the height range alone: the variance of any
/// normalised combination of its end heights is at most kMaxVarianceShare of that of the range.
bool is_determined(const ReconstructedLine& line, const std::array<double, 2>& heights_m) {
  constexpr double kMaxVarianceShare = 0.01;
  const Matrix6d& cov = *line.covariance_m2;
  const double range_m = heights_m[1] - heights_m[0];
  const double largest =
      0.5 * (cov(2, 2) + cov(5, 5) + std::hypot(cov(2, 2) - cov(5, 5), 2.0 * cov(2, 5)));
  return largest <= kMaxVarianceShare * range_m * range_m / 12.0;
}

/// Whether the line has more meetings than `joint` has points on it and, if `joint` has any, a more
/// certain height.
bool is_better_known(const ReconstructedLine& by_network, int n_meetings, const JointLine& joint) {
  const auto n_points = static_cast<int>(joint.line.points.size() + joint.support.ends.size());
  if (n_meetings <= n_points) return false;
  return n_points == 0 || !joint.line.covariance_m2 ||
         largest_sigma_z_m(*by_network.covariance_m2) <=
             largest_sigma_z_m(*joint.line.covariance_m2);
}

}  // namespace

void adjust_together(const TrackedLines& lines,
                     std::span<const PairConnection> connections,
                     const EstimationOptions& options,
                     std::vector<std::vector<JointLine>>& by_track) {
  const Members members = members_of(lines, by_track);
  const std::vector<Meeting> meetings =
      meetings_of(lines, connections, members, options.building.sigma_meeting_m);
  const std::vector<AdjustedInNetwork> adjusted = adjust_network(
      lines.frames, members.lines, meetings, lines.height_range_in_local_m, options.building);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    ReconstructedLine& joint = members.results[i]->line;
    if (!adjusted[i].adjusted) continue;
    ReconstructedLine line = joint;
    if (!assign_geometry(lines, members.lines[i].track, adjusted[i].line, line) ||
        !is_determined(line, lines.height_range_in_local_m) ||
        !is_better_known(line, adjusted[i].n_meetings, *members.results[i])) {
      continue;
    }
    line.determination = Determination::kNetwork;
    line.failure.reset();
    line.n_meetings = adjusted[i].n_meetings;
    line.omega = adjusted[i].omega;
    line.points.clear();
    joint = line;
  }
}

}  // namespace ridgeline::reconstruct
