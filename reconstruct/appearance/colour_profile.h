// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Fewer pixels than these beside a segment make no profile.
inline constexpr std::size_t kMinProfileSamples = 60;

/// A pixel beside a segment.
struct ProfileSample {
  double across;  ///< distance along n = (-u_y, u_x), u = end - start, in units of the profile
  double tau;     ///< -1 at the start of the segment, 1 at its end
  Eigen::Vector4d colour;  ///< 0 where the image has fewer bands
};

/// Half the width of the profile of close edges: two pixels and room for the blur on both sides.
double profile_half_width_px(double blur_px);

/// The pixels up to `half_width` units beside a segment, without interpolation. Pixels next to its
/// ends are left out, because corners disturb the profile there; a segment of a few pixels has
/// none.
/// @param image    CV_32FC(n), n = 1..4
/// @param unit_px  the unit of distances across: 1, or more for edges wider than a pixel
std::vector<ProfileSample> profile_samples(const cv::Mat& image,
                                           const Segment2& segment,
                                           double half_width,
                                           double unit_px = 1.0);

/// The value at z of an edge of height 1 at 0 that is blurred with sigma 1.
double step_response(double z);

/// Blurred steps at a series of offsets, over the bins of a profile.
struct StepBasis {
  Eigen::VectorXd offsets_px;
  Eigen::MatrixXd responses;  ///< offsets x bins

  StepBasis(double half_width_px, double largest_offset_px, double blur_px);
};

/// Sums over the samples of a profile, per bin of their distance across.
struct BinnedProfile {
  Eigen::VectorXd counts;
  Eigen::MatrixX4d sums;
  double squares = 0.0;  ///< sum of the squared differences from the mean colour

  BinnedProfile(std::span<const ProfileSample> samples, double half_width_px);
};

/// The normal equations of the steps, from which the constant colour is eliminated.
struct StepEquations {
  Eigen::MatrixXd normal;  ///< offsets x offsets
  Eigen::MatrixX4d right;  ///< offsets x bands

  StepEquations(const StepBasis& basis, const BinnedProfile& profile);

  /// By how much steps at two offsets reduce the sum of squares; 0 if the bins do not tell them
  /// apart.
  [[nodiscard]] double gain(Eigen::Index i, Eigen::Index j) const;
};

/// By how much the best single step reduces the sum of squares.
double best_gain(const StepBasis& basis, const BinnedProfile& profile);

}  // namespace ridgeline::reconstruct
