// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Minimum number of pixels beside a segment for a profile.
inline constexpr std::size_t kMinProfileSamples = 60;

/// A pixel beside a segment.
struct ProfileSample {
  double across;           ///< distance along n = (-u_y, u_x), u = end - start, in profile units
  double tau;              ///< -1 at the start of the segment, 1 at its end
  Eigen::Vector4d colour;  ///< 0 where the image has fewer bands
};

/// Half-width of the profile of close edges: two pixels plus room for the blur on each side.
double profile_half_width_px(double blur_px);

/// The pixels at most `half_width` units away from a segment, without interpolation. Pixels next to
/// its ends are left out, because corners disturb the profile there, so a segment of a few pixels
/// has no samples.
/// @param image    CV_32FC(n), n = 1..4
/// @param unit_px  the unit of distances across the segment: 1, or more for edges wider than a
///                 pixel
std::vector<ProfileSample> profile_samples(const cv::Mat& image,
                                           const Segment2& segment,
                                           double half_width,
                                           double unit_px = 1.0);

/// The value at z of a step of height 1 at 0, blurred with sigma 1.
double step_response(double z);

/// Blurred steps at a series of offsets, sampled in the bins of a profile.
struct StepBasis {
  Eigen::VectorXd offsets_px;
  Eigen::MatrixXd responses;  ///< offsets x bins

  StepBasis(double half_width_px, double largest_offset_px, double blur_px);
};

/// Sums over the samples of a profile, binned by their distance across the segment.
struct BinnedProfile {
  Eigen::VectorXd counts;
  Eigen::MatrixX4d sums;
  double squares = 0.0;  ///< sum of the squared differences from the mean colour

  BinnedProfile(std::span<const ProfileSample> samples, double half_width_px);
};

/// The normal equations of the steps, after elimination of the constant colour.
struct StepEquations {
  Eigen::MatrixXd normal;  ///< offsets x offsets
  Eigen::MatrixX4d right;  ///< offsets x bands

  StepEquations(const StepBasis& basis, const BinnedProfile& profile);

  /// The reduction of the sum of squares by steps at two offsets; 0 if the bins cannot separate
  /// them.
  [[nodiscard]] double gain(Eigen::Index i, Eigen::Index j) const;
};

/// The reduction of the sum of squares by the best single step.
double best_gain(const StepBasis& basis, const BinnedProfile& profile);

}  // namespace ridgeline::reconstruct
