// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/image_sampler.h"
#include "reconstruct/appearance/line_similarity.h"
#include "reconstruct/geometry/edge_segment.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

// The eight pair-wise constraints (Ok et al. 2011, section 2): how well a pair
// of segments of the left image agrees with a pair of the right one. Each is in [0, 1], 1 for
// perfect agreement, and absent where it is not defined.

/// A pair of segments in one image, in ideal pixels. In the right image, the segments have the
/// direction of their left counterparts.
struct PairShape {
  Segment2 first, second;  ///< each clipped to its epipolar overlap with its counterpart
  Eigen::Vector2d intersection;
  bool clipped = true;  ///< false if a member is near-aligned, so that its ends do not correspond
};

/// Constraint 1: the intersection points lie on each other's epipolar lines. exp(-d^2 / (2
/// sigma^2)) for their mean distance d. sigma combines the precision of the segments
/// (intersection_sigma_px) with kMeetSigma_px, because edges of a building rarely meet in one
/// point: they pass each other at gutters and overhangs.
std::optional<double> epipolar_similarity(double distance_px, double sigma_px);
inline constexpr double kMeetSigma_px = 1.0;

/// Standard deviation of the intersection of two segments along a unit direction (Eq. 2, in
/// Euclidean coordinates).
double intersection_sigma_px(const UncertainSegment2& a,
                             const UncertainSegment2& b,
                             const Eigen::Vector2d& intersection,
                             const Eigen::Vector2d& direction);

/// Constraint 2: the oriented angle from the first to the second segment. Always defined for a
/// pair. In constraints 2 to 4, `spread` multiplies the differences expected between correct pairs.
std::optional<double> angle_similarity(const PairShape& left,
                                       const PairShape& right,
                                       double spread = 1.0);

/// Constraint 3: the direction from midpoint to midpoint, measured from the first segment. Absent
/// if a member is near-aligned or the midpoints coincide.
std::optional<double> direction_similarity(const PairShape& left,
                                           const PairShape& right,
                                           double spread = 1.0);

/// Constraint 4: the sum of the lengths over the mean distance of the end points of one segment
/// from those of the other. Absent if a member is near-aligned.
std::optional<double> extent_similarity(const PairShape& left,
                                        const PairShape& right,
                                        double spread = 1.0);

/// Constraints 5 and 6 compare single lines: colour_similarity() and contrast_similarity() in
/// appearance/line_similarity.h.

/// The image content spanned by a pair, sampled on a grid in the pair's own affine frame: the
/// origin is the intersection point, and the axes run along the segments.
struct PairPatch {
  static constexpr int kSize = 12;
  static constexpr int kNumSamples = kSize * kSize;
  int n_bands = 0;
  std::array<Colour, kNumSamples> colours{};
};

/// Frame of a pair: x = origin + alpha first + beta second, alpha and beta in [0, 1].
struct PairFrame {
  Eigen::Vector2d origin, first, second;
};

/// Samples the parallelogram of the frame; empty if part of it lies outside the image.
std::optional<PairPatch> pair_patch(const ImageSampler& image, const PairFrame& frame);

/// Constraint 7: normalised cross-correlation over all bands, with negative values set to 0. Absent
/// without texture.
std::optional<double> correlation(const PairPatch& left, const PairPatch& right);

/// Constraint 8: similarity of the spatiograms, which are 8-bin histograms that include the
/// positions of their pixels (O Conaire et al. 2007), averaged over the bands. It is exactly 1 for
/// equal patches and invariant to affine changes of the pair.
std::optional<double> spatiogram_similarity(const PairPatch& left, const PairPatch& right);

}  // namespace ridgeline::reconstruct
