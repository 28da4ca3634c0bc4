// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/views/conditioned_view.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// What comparing the images beside the edges of a match tells of their places.
struct Registration {
  double right_shift_px = 0.0;  ///< of the right segment along n = (-u_y, u_x)
  double sigma_scale = 1.0;     ///< of the sigmas across both segments
};

/// The matched segments of two images, which it borrows.
struct MatchedSegments {
  std::span<const ProjectionMatrix> cameras;  ///< image_from_local of the left (base), the right
  std::span<const std::vector<UncertainSegment2>> segments;  ///< of the left, the right image
  std::span<const LineMatch> matches;
  std::span<const PairConnection> connections;    ///< in either order; repetitions change nothing
  std::span<const Registration> registrations{};  ///< by match; or none
  std::array<double, 2> height_range_in_local_m{-1e5, 1e5};  ///< default: no limit on Earth
};

using Mates = std::array<UncertainSegment2, 2>;  ///< left, right

/// The segments of each match as they were extracted. Throws std::invalid_argument for an index out of range.
std::vector<Mates> extracted_mates(const MatchedSegments& matched);

/// The segments of each match as their registration, if there are any, has them. Throws as extracted_mates().
std::vector<Mates> registered_mates(const MatchedSegments& matched);

/// The matched lines of a stereo pair in the conditioned frames, ready for estimation.
struct StereoLines {
  StereoViews stereo;
  Eigen::Matrix3d right_from_left;  ///< fundamental matrix of the conditioned images
  std::vector<ObservedPair> lines;  ///< by match
  std::array<double, 2> height_range_in_local_m{};
};

/// The matches in the conditioned frames of the patch, which the segments as extracted define; of a left segment with
/// several mates each match gets the part that its mate shows.
/// @param observed  the segments of each match that are to be taken
/// Throws as condition() and observe() do.
StereoLines stereo_lines(const MatchedSegments& matched,
                         const std::vector<Mates>& observed,
                         LineCovariance form);

/// Where two matches cross in both images, conditioned.
std::array<Eigen::Vector2d, 2> crossing(const ObservedPair& line, const ObservedPair& other);

using Neighbours = std::vector<std::vector<int>>;  ///< by match, ascending

/// The matches that each is connected with. Throws std::invalid_argument for an index out of range and for
/// a match connected with itself.
Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_matches);

}  // namespace ridgeline::reconstruct
