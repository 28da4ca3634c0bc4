// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/tracked_lines.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <map>

namespace ridgeline::reconstruct {
namespace {

std::size_t checked_index(const char* what, int index, std::size_t size) {
  check(index >= 0 && static_cast<std::size_t>(index) < size, what, " = ", index,
        ", must be in [0, ", size, ")");
  return static_cast<std::size_t>(index);
}

UncertainSegment2 registered(const UncertainSegment2& segment, const Registration& r) {
  const Eigen::Vector2d by = r.shift_px * normal(segment.segment);
  UncertainSegment2 moved = segment;
  for (Eigen::Vector2d* x : {&moved.segment.start, &moved.segment.end, &moved.centroid_px})
    *x += by;
  moved.sigma_q_px *= r.sigma_scale;
  moved.sigma_phi_rad *= r.sigma_scale;
  return moved;
}

/// Parameter at which the epipolar line of a point in the other image crosses the line of a base
/// segment.
double epipolar_crossing(const Segment2& base,
                         const Eigen::Vector2d& in_other,
                         const Eigen::Matrix3d& other_from_base) {
  const Eigen::Vector3d epipolar_line = other_from_base.transpose() * in_other.homogeneous();
  const double at_start = epipolar_line.dot(base.start.homogeneous());
  const double at_end = epipolar_line.dot(base.end.homogeneous());
  return at_start / (at_start - at_end);
}

/// Keeps the part of the base segment that shows what the other segment shows. Otherwise a segment
/// with several fragments in the other view would give its whole length to the line of each
/// fragment.
void clip_to_other(ObservedTrack& track, const Eigen::Matrix3d& other_from_base) {
  // Share of the segment; the epipolar lines run along it if the part is shorter.
  constexpr double kMinShare = 0.02;
  const Segment2 base = track.base().segment;
  const auto [low, high] =
      std::minmax({epipolar_crossing(base, track.other().segment.start, other_from_base),
                   epipolar_crossing(base, track.other().segment.end, other_from_base)});
  const double from = std::max(0.0, low);
  const double to = std::min(1.0, high);
  if (!(to - from > kMinShare)) return;
  track.base().segment = {base.start + from * (base.end - base.start),
                          base.start + to * (base.end - base.start)};
}

}  // namespace

std::vector<TrackSegments> extracted(const TrackedSegments& tracked) {
  return transformed(tracked.tracks, [&](const Track& track) {
    check(track.observations.size() >= 2 && track.base().view != track.other().view,
          "track: must begin with observations of two views");
    return transformed(track.observations, [&](const Observation& s) {
      check(s.view < tracked.segments.size(), "track: view = ", s.view, ", must be in [0, ",
            tracked.segments.size(), ")");
      const std::vector<UncertainSegment2>& of_view = tracked.segments[s.view];
      return of_view[checked_index("track: segment", s.segment, of_view.size())];
    });
  });
}

std::vector<TrackSegments> registered(const TrackedSegments& tracked) {
  std::vector<TrackSegments> all = extracted(tracked);
  for (std::size_t i = 0; i < tracked.registrations.size(); ++i) {
    for (std::size_t s = 0; s < all[i].size(); ++s)
      all[i][s] = registered(all[i][s], tracked.registrations[i][s]);
  }
  return all;
}

TrackedLines tracked_lines(const TrackedSegments& tracked,
                           const std::vector<TrackSegments>& observed,
                           LineCovariance form) {
  std::vector<std::vector<Segment2>> patch(tracked.cameras.size());
  std::map<Observation, int> num_tracks;  // by base segment
  const std::vector<TrackSegments> seen = extracted(tracked);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Track& track = tracked.tracks[i];
    for (std::size_t s = 0; s < seen[i].size(); ++s)
      patch[track.observations[s].view].push_back(seen[i][s].segment);
    ++num_tracks[track.base()];
  }
  TrackedLines lines{condition(tracked.cameras, patch), {}, tracked.height_range_in_local_m};
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const Track& track = tracked.tracks[i];
    ObservedTrack& line = lines.lines.emplace_back();
    for (std::size_t s = 0; s < track.observations.size(); ++s)
      line.observations.push_back(
          observe(lines.frames, track.observations[s].view, observed[i][s], form));
    if (num_tracks[track.base()] > 1)
      clip_to_other(line, lines.frames.fundamental(line.base().view, line.other().view));
  }
  return lines;
}

std::vector<SeenTogether> seen_together(const ObservedTrack& line, const ObservedTrack& other) {
  std::vector<SeenTogether> views;
  for (const ObservedLine& own : line.observations) {
    const auto is_of_view = [&](const ObservedLine& seen) { return seen.view == own.view; };
    if (std::ranges::any_of(views, [&](const SeenTogether& v) { return is_of_view(v.line); }))
      continue;
    const auto found = std::ranges::find_if(other.observations, is_of_view);
    if (found != other.observations.end()) views.push_back({own, *found});
  }
  return views;
}

Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_tracks) {
  Neighbours neighbours(num_tracks);
  for (const PairConnection& c : connections) {
    check(c.i != c.k, "connection: i = k = ", c.i, ", must be two tracks");
    neighbours[checked_index("connection: i", c.i, num_tracks)].push_back(c.k);
    neighbours[checked_index("connection: k", c.k, num_tracks)].push_back(c.i);
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

}  // namespace ridgeline::reconstruct
