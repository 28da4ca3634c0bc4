// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/estimate/ok2011/candidate_points.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Sigma along the line of segment ends that show the same point (calibration.md).
inline constexpr double kSigmaOfEnds_px = 1.0;

/// An aligned track in the frames of the estimation. The base segment and the other one determine
/// its depth. Borrows its arguments.
struct AlignedTrack {
  AlignedTrack(const TrackedLines& all, const ObservedTrack& observed);

  const TrackedLines& lines;
  const ObservedTrack& line;
  /// Whether the other segment runs opposite to the base segment, whatever the rule by which
  /// segments are directed.
  bool runs_back;

  /// The starts (0) or the ends (1) of both segments, in the direction of the base segment.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> ends(int which) const;
  /// Where both views show an artificial point of the line.
  [[nodiscard]] std::array<Eigen::Vector2d, 2> places_of(const CandidatePoint& point) const;
};

/// The evidence for the depth of a track: the artificial points of sufficient weight, and the
/// points shown by its ends.
struct TrackEvidence {
  AlignedTrack track;
  std::vector<CandidatePoint> points;
  std::vector<UncertainPoint3> ends;
  std::vector<int> which_ends;          ///< for each of `ends`: 0 starts, 1 ends of the segments
  std::vector<DepthEvidence> on_depth;  ///< the evidence of the points, then that of the ends
};

TrackEvidence evidence_of(const AlignedTrack& track, std::span<const int> neighbours);

/// The point in object space at given positions on the segments of both views. Empty if there is no
/// such point in front of the cameras and within the height range.
/// @param x         the positions in the base view and the other one, conditioned
/// @param sigma_px  sigma of both positions along the line
std::optional<UncertainPoint3> point_in_object(const AlignedTrack& track,
                                               const std::array<Eigen::Vector2d, 2>& x,
                                               double sigma_px);

}  // namespace ridgeline::reconstruct
