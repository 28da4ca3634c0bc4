// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/views/conditioned_view.h"

#include <array>
#include <span>
#include <vector>

// What reconstruct_lines() is given, checked, in the form that it computes with.

namespace ridgeline::reconstruct {

/// The matched lines of a stereo pair in the conditioned frames, ready for estimation.
struct StereoLines {
  StereoViews stereo;
  Eigen::Matrix3d right_from_left;  ///< fundamental matrix of the conditioned images
  std::vector<ObservedPair> lines;  ///< by match
};

using Mates = std::array<UncertainSegment2, 2>;  ///< left, right

/// What comparing the images beside the edges of a match tells of their places.
struct Registration {
  double right_shift_px = 0.0;  ///< of the right segment along n = (-u_y, u_x)
  double sigma_scale = 1.0;     ///< of the sigmas across both segments
};

/// The segments of each match, as their registration, if there are any, has them.
/// Throws std::invalid_argument for an index out of range.
std::vector<Mates> matched_segments(std::span<const std::vector<UncertainSegment2>> segments,
                                    std::span<const LineMatch> matches,
                                    std::span<const Registration> registrations);

/// The matches in the conditioned frames of the patch; of a left segment with several mates each gets the
/// part that its mate shows.
/// @param patch     the mates as extracted, which the conditioning is taken from: the same for all that is
///                  to be compared
/// @param observed  the mates to be taken
/// Throws as condition() and observe() do.
StereoLines stereo_lines(std::span<const ProjectionMatrix> cameras,
                         const std::vector<Mates>& patch,
                         const std::vector<Mates>& observed,
                         std::span<const LineMatch> matches,
                         LineCovariance form);

/// Where two matches cross in both images, conditioned.
std::array<Eigen::Vector2d, 2> crossing(const ObservedPair& line, const ObservedPair& other);

using Neighbours = std::vector<std::vector<int>>;  ///< by match, ascending

/// The matches that each is connected with. Throws std::invalid_argument for an index out of range and for
/// a match connected with itself.
Neighbours neighbours_of(std::span<const PairConnection> connections, std::size_t num_matches);

}  // namespace ridgeline::reconstruct
