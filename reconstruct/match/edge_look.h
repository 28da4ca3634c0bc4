// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/match/epipolar_overlap.h"
#include "reconstruct/match/image_sampler.h"

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// Brings the colours of the right image to those of the left one, per band: gain x + offset.
struct Radiometry {
  Colour gain{1.0F, 1.0F, 1.0F, 1.0F};
  Colour offset{};

  [[nodiscard]] Colour left_from_right(const Colour& right) const {
    Colour left{};
    for (int band = 0; band < kMaxBands; ++band)
      left[band] = gain[band] * right[band] + offset[band];
    return left;
  }
};

/// The map that gives the flanks of the right segments the means and spreads of those of the left
/// ones; both images show mostly the same. Identity for fewer than ten segments in an image.
Radiometry relative_radiometry(std::span<const EdgeSegment> left,
                               std::span<const EdgeSegment> right);

/// How similar the strips along one side of a line are in the two images.
struct SideLook {
  double ncc = 0.0;                ///< -1..1, all bands together, damped where there is no texture
  double colour_difference = 0.0;  ///< of the mean colours, root mean square over the bands
};

/// The two sides of a line. A side is absent where its strip leaves one of the images.
struct EdgeLook {
  std::array<std::optional<SideLook>, 2> sides;  ///< left, right of the left segment's direction
  /// Correlation of the mean profiles across the line, -1..1: tells it from parallel lines a few
  /// pixels away, as gutters make them. Absent where the profile leaves one of the images.
  std::optional<double> profile_ncc;
};

/// A pair of images with what it takes to compare them.
struct ImagePair {
  ImageSampler left, right;
  Radiometry radiometry;
};

/// How densely and how far from the line the strips are sampled.
struct StripGrid {
  double first_offset_px = 1.5;  ///< clear of the blurred edge
  double offset_step_px = 1.0;
  int n_offsets = 8;
  int most_along = 20;
  int n_slopes = 3;  ///< 1: level sides only
  bool with_profile = true;
};

/// Compares each side of a left segment with the same side of a right one over their epipolar
/// overlap. A side is a plane through the line of an unknown slope (Schmid and Zisserman 1997): the
/// best of level and 35 degrees up or down counts. Judging each side by itself tolerates that the
/// other one is occluded, which is the rule at eaves.
/// @param transfer  of the left image to the right one, near the segment
EdgeLook edge_look(const ImagePair& images,
                   const EdgeSegment& left,
                   const EdgeSegment& right,
                   const EpipolarOverlap& overlap,
                   const LocalTransfer& transfer,
                   const StripGrid& grid = {});

}  // namespace ridgeline::reconstruct
