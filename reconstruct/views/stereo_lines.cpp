// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/views/stereo_lines.h"

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

UncertainSegment2 registered(const UncertainSegment2& segment,
                             double across_px,
                             double sigma_scale) {
  const Eigen::Vector2d by = across_px * normal(segment.segment);
  UncertainSegment2 moved = segment;
  for (Eigen::Vector2d* x : {&moved.segment.start, &moved.segment.end, &moved.centroid_px})
    *x += by;
  moved.sigma_q_px *= sigma_scale;
  moved.sigma_phi_rad *= sigma_scale;
  return moved;
}

/// Parameter at which the epipolar line of a point of the right image crosses the line of a left
/// segment.
double epipolar_crossing(const Segment2& left,
                         const Eigen::Vector2d& in_right,
                         const Eigen::Matrix3d& right_from_left) {
  const Eigen::Vector3d epipolar_line = right_from_left.transpose() * in_right.homogeneous();
  const double at_start = epipolar_line.dot(left.start.homogeneous());
  const double at_end = epipolar_line.dot(left.end.homogeneous());
  return at_start / (at_start - at_end);
}

/// Keeps the part of the left segment that shows what the right one shows. Otherwise a segment with several
/// fragments as mates would give each of their lines its whole length.
void clip_to_mate(ObservedPair& pair, const Eigen::Matrix3d& right_from_left) {
  // Share of the segment; the epipolar lines run along it if the part is shorter.
  constexpr double kShortest = 0.02;
  const Segment2 left = pair[0].segment;
  const auto [low, high] =
      std::minmax({epipolar_crossing(left, pair[1].segment.start, right_from_left),
                   epipolar_crossing(left, pair[1].segment.end, right_from_left)});
  const double from = std::max(0.0, low);
  const double to = std::min(1.0, high);
  if (!(to - from > kShortest)) return;
  pair[0].segment = {left.start + from * (left.end - left.start),
                     left.start + to * (left.end - left.start)};
}

}  // namespace

std::vector<Mates> extracted_mates(const MatchedSegments& matched) {
  return transformed(matched.matches, [&](const LineMatch& match) -> Mates {
    const auto& [left, right] = match;
    return {
        matched.segments[0][checked_index("match: left segment", left, matched.segments[0].size())],
        matched
            .segments[1][checked_index("match: right segment", right, matched.segments[1].size())]};
  });
}

std::vector<Mates> registered_mates(const MatchedSegments& matched) {
  std::vector<Mates> mates = extracted_mates(matched);
  for (std::size_t i = 0; i < matched.registrations.size(); ++i) {
    const Registration& r = matched.registrations[i];
    mates[i] = {registered(mates[i][0], 0.0, r.sigma_scale),
                registered(mates[i][1], r.right_shift_px, r.sigma_scale)};
  }
  return mates;
}

StereoLines stereo_lines(const MatchedSegments& matched,
                         const std::vector<Mates>& observed,
                         LineCovariance form) {
  std::array<std::vector<Segment2>, 2> seen;
  for (const Mates& mates : extracted_mates(matched)) {
    for (std::size_t j = 0; j < 2; ++j) seen[j].push_back(mates[j].segment);
  }
  StereoLines lines;
  lines.height_range_in_local_m = matched.height_range_in_local_m;
  lines.stereo = condition(matched.cameras.first<2>(), {seen[0], seen[1]});
  const std::array<ConditionedView, 2>& views = lines.stereo.views;
  lines.right_from_left =
      fundamental_matrix(views[0].image_from_object, views[1].image_from_object);
  std::map<int, int> num_mates;
  for (const LineMatch& match : matched.matches) ++num_mates[match.left];
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const auto& [left, right] = observed[i];
    lines.lines.push_back({observe(views[0], left, form), observe(views[1], right, form)});
    if (num_mates[matched.matches[i].left] > 1)
      clip_to_mate(lines.lines.back(), lines.right_from_left);
  }
  return lines;
}

std::array<Eigen::Vector2d, 2> crossing(const ObservedPair& line, const ObservedPair& other) {
  return {line[0].line.mean.cross(other[0].line.mean).hnormalized(),
          line[1].line.mean.cross(other[1].line.mean).hnormalized()};
}

Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_matches) {
  Neighbours neighbours(num_matches);
  for (const PairConnection& c : connections) {
    check(c.i != c.k, "connection: i = k = ", c.i, ", must be two matches");
    neighbours[checked_index("connection: i", c.i, num_matches)].push_back(c.k);
    neighbours[checked_index("connection: k", c.k, num_matches)].push_back(c.i);
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

}  // namespace ridgeline::reconstruct
