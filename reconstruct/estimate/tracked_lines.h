// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/track.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The correction of the position of a segment, found by comparing the images beside it and beside
/// the track's base segment.
struct Registration {
  double shift_px = 0.0;     ///< along n = (-u_y, u_x) of the segment
  double sigma_scale = 1.0;  ///< factor for its sigma_q and sigma_phi
};
using Registrations = std::vector<Registration>;  ///< one per observation of a track

/// The segments of tracks in several images, all borrowed.
struct TrackedSegments {
  std::span<const ProjectionMatrix> cameras;                 ///< `image_from_local`, by view
  std::span<const std::vector<UncertainSegment2>> segments;  ///< by view
  std::span<const Track> tracks;
  std::span<const PairConnection> connections;     ///< in either order; repetitions change nothing
  std::span<const Registrations> registrations{};  ///< one per track, or empty
  std::array<double, 2> height_range_in_local_m{-1e5, 1e5};  ///< default: no limit on Earth
};

using TrackSegments = std::vector<UncertainSegment2>;  ///< the segments of a track, in the order of
                                                       ///< Track::observations

/// The segments of each track as they were extracted. Throws std::invalid_argument for an index out
/// of range and for a track whose first two observations come from the same view.
std::vector<TrackSegments> extracted(const TrackedSegments& tracked);

/// The segments of each track, corrected by its registrations if there are any. Throws under the
/// same conditions as extracted().
std::vector<TrackSegments> registered(const TrackedSegments& tracked);

/// The lines of tracks in the conditioned frames, ready for estimation.
struct TrackedLines {
  ConditionedViews frames;
  std::vector<ObservedTrack> lines;  ///< by track
  std::array<double, 2> height_range_in_local_m{};
  /// Whether a line of two images is the part that both show, not the part that the base segment
  /// shows.
  bool common_part = false;
};

/// The tracks in the conditioned frames of the patch, which the extracted segments define. If a
/// base segment belongs to several tracks, each gets the part that the other segment shows.
/// @param observed  the segments of each track that are used
/// Throws under the same conditions as condition() and observe().
TrackedLines tracked_lines(const TrackedSegments& tracked,
                           const std::vector<TrackSegments>& observed,
                           LineCovariance form);

/// Two lines as seen in one view.
struct SeenTogether {
  const ObservedLine& line;
  const ObservedLine& other;

  /// The point where their lines cross in the image, conditioned.
  [[nodiscard]] Eigen::Vector2d crossing() const {
    return line.line.mean.cross(other.line.mean).hnormalized();
  }
};

/// The views that show both lines, in the order of the first one's observations, each once.
std::vector<SeenTogether> seen_together(const ObservedTrack& line, const ObservedTrack& other);

using Neighbours = std::vector<std::vector<int>>;  ///< by track, ascending

/// The tracks that each track is connected with. Throws std::invalid_argument for an index out of
/// range and for a track connected with itself.
Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_tracks);

}  // namespace ridgeline::reconstruct
