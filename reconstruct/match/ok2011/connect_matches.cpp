// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/connect_matches.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/match/ok2011/base_pairs.h"
#include "reconstruct/match/ok2011/pair_similarity.h"

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

bool meet_in_both(const std::array<Segment2, 2>& a,
                  const std::array<Segment2, 2>& b,
                  const Eigen::Matrix3d& right_from_left,
                  double spread) {
  std::array<Eigen::Vector2d, 2> x;
  std::array<double, 2> angle_rad{};
  for (const int image : {0, 1}) {
    const auto meeting = intersection(a[image], b[image], kMinPairAngle_deg * kRadPerDeg);
    if (!meeting) return false;
    x[image] = *meeting;
    angle_rad[image] = acute_angle_rad(a[image], b[image]);
  }
  const double apart_px = 0.5 * (epipolar_distance_px(right_from_left, x[0], x[1]) +
                                 epipolar_distance_px(right_from_left.transpose(), x[1], x[0]));
  return apart_px <= kMaxPairEpipolar_px &&
         std::abs(angle_rad[0] - angle_rad[1]) <= spread * kMaxPairTurn_deg * kRadPerDeg;
}

Eigen::Vector2d mean_midpoint(std::span<const Segment2> segments) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Segment2& segment : segments) sum += midpoint(segment);
  return sum / static_cast<double>(segments.size());
}

}  // namespace

std::vector<PairConnection> connect_matches(const StereoPair& pair,
                                            std::span<const Correspondence> matches) {
  const std::vector<EdgeSegment>& left = pair.views[0]->segments;
  const std::vector<EdgeSegment>& right = pair.views[1]->segments;
  const auto [left_camera, right_camera] = pair.cameras();
  const StereoSearch search(left_camera, right_camera, pair.height_range_in_local_m);
  std::vector<Segment2> in_left;
  for (const Correspondence& match : matches) {
    check(match.base >= 0 && match.base < static_cast<int>(left.size()), "left_id = ", match.base,
          ", must be below ", left.size());
    check(match.other >= 0 && match.other < static_cast<int>(right.size()),
          "right_id = ", match.other, ", must be below ", right.size());
    in_left.push_back(left[match.base].line.segment);
  }
  std::vector<PairConnection> connections;
  if (matches.empty()) return connections;
  const double spread = relief_spread(local_transfer(search, mean_midpoint(in_left)));
  for (const auto& [i, k] : base_pairs(in_left)) {
    const Correspondence& a = matches[i];
    const Correspondence& b = matches[k];
    if (a.other == b.other) continue;
    if (meet_in_both({in_left[i], right[a.other].line.segment},
                     {in_left[k], right[b.other].line.segment},
                     search.right_from_left.fundamental(), spread)) {
      connections.push_back({i, k});
    }
  }
  return connections;
}

}  // namespace ridgeline::reconstruct
