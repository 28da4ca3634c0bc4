// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/beyond/options.h"
#include "reconstruct/ok2011/estimate/candidate_points.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// An aligned match in the frames of the estimation. It borrows what it is made of.
struct AlignedMatch {
  AlignedMatch(const StereoLines& all, const ObservedPair& observed);

  const StereoLines& lines;
  const ObservedPair& line;
  /// Whether the right segment runs the other way than the left one. The rule by which the segments were
  /// directed does not matter.
  bool runs_back;

  /// The starts (0) or the ends (1) of both segments, in the direction of the left one.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> ends(int which) const;
  /// Where the match crosses another one in both images.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> crossing_with(int other) const;
};

/// What tells the depth of a match: the artificial points of sufficient weight, and the points that its ends show.
struct MatchEvidence {
  AlignedMatch match;
  std::vector<CandidatePoint> points;
  std::vector<UncertainPoint3> ends;
  std::vector<int> which_ends;          ///< for each of `ends`: 0 starts, 1 ends of the segments
  std::vector<DepthEvidence> on_depth;  ///< the evidence of the points, then that of the ends
};

MatchEvidence evidence_of(const AlignedMatch& match,
                          std::span<const int> neighbours,
                          const EstimationOptions& options);

/// The point in object space that both images show, by its place on the segment of each image. The result is empty if there is
/// no such point in front of the cameras and within the range of heights.
/// @param x         the places in the left and the right image, conditioned
/// @param sigma_px  sigma of both places along the line
std::optional<UncertainPoint3> point_in_object(const AlignedMatch& match,
                                               const std::array<Eigen::Vector2d, 2>& x,
                                               double sigma_px);

}  // namespace ridgeline::reconstruct
