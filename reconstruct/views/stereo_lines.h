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

/// The correction of the places of a match's segments, found by comparing the images beside them.
struct Registration {
  double right_shift_px = 0.0;  ///< shift of the right segment along n = (-u_y, u_x)
  double sigma_scale = 1.0;     ///< factor of sigma_q and sigma_phi of both segments
};

/// The matched segments of two images, which it borrows.
struct MatchedSegments {
  /// The cameras `image_from_local` of the left (base) and the right image.
  std::span<const ProjectionMatrix> cameras;
  /// Segments of the left and of the right image.
  std::span<const std::vector<UncertainSegment2>> segments;
  std::span<const LineMatch> matches;
  std::span<const PairConnection> connections;    ///< in either order; repetitions change nothing
  std::span<const Registration> registrations{};  ///< one per match, or empty
  std::array<double, 2> height_range_in_local_m{-1e5, 1e5};  ///< default: no limit on Earth
};

using Mates = std::array<UncertainSegment2, 2>;  ///< left, right

/// The segments of each match as they were extracted. Throws std::invalid_argument for an index out of range.
std::vector<Mates> extracted_mates(const MatchedSegments& matched);

/// The segments of each match, corrected by its registration if there are any. Throws as extracted_mates()
/// does.
std::vector<Mates> registered_mates(const MatchedSegments& matched);

/// The matched lines of a stereo pair in the conditioned frames, ready for estimation.
struct StereoLines {
  StereoViews stereo;
  Eigen::Matrix3d right_from_left;  ///< fundamental matrix of the conditioned images
  std::vector<ObservedPair> lines;  ///< by match
  std::array<double, 2> height_range_in_local_m{};
};

/// The matches in the conditioned frames of the patch, which the extracted segments define. If a left segment
/// has several mates, each match gets the part that its mate shows.
/// @param observed  the segments of each match that are used
/// Throws as condition() and observe() do.
StereoLines stereo_lines(const MatchedSegments& matched,
                         const std::vector<Mates>& observed,
                         LineCovariance form);

/// The points where the lines of two matches cross in the left and in the right image, conditioned.
std::array<Eigen::Vector2d, 2> crossing(const ObservedPair& line, const ObservedPair& other);

using Neighbours = std::vector<std::vector<int>>;  ///< by match, ascending

/// The matches that each match is connected with. Throws std::invalid_argument for an index out of range and
/// for a match connected with itself.
Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_matches);

}  // namespace ridgeline::reconstruct
