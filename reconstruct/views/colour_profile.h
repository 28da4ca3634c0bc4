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
inline constexpr std::size_t kFewestProfileSamples = 60;

/// A pixel beside a segment.
struct ProfileSample {
  double across_px;        ///< distance along n = (-u_y, u_x), u = end - start
  double tau;              ///< -1 at the start of the segment, 1 at its end
  Eigen::Vector4d colour;  ///< 0 where the image has fewer bands
};

/// Half the width of the profile of close edges: two pixels and room for the blur on both sides.
double profile_half_width_px(double blur_px);

/// The pixels up to `half_width_px` beside a segment, as they are: none is interpolated. Those next
/// to its ends are left out, where corners disturb the profile; a segment of a few pixels has none.
/// @param image  CV_32FC(n), n = 1..4
std::vector<ProfileSample> profile_samples(const cv::Mat& image,
                                           const Segment2& segment,
                                           double half_width_px);

/// An edge of height 1 at 0, blurred with sigma 1.
double step_response(double z);

/// Blurred steps at a series of offsets, over the bins of a profile.
struct StepBasis {
  Eigen::VectorXd offsets_px;
  Eigen::MatrixXd responses;  ///< offsets x bins

  StepBasis(double half_width_px, double largest_offset_px, double blur_px);
};

/// Sums over a profile's samples, by bin across.
struct BinnedProfile {
  Eigen::VectorXd counts;
  Eigen::MatrixX4d sums;
  double squares = 0.0;  ///< about the mean colour

  BinnedProfile(std::span<const ProfileSample> samples, double half_width_px);
};

/// The steps' normal equations, the constant colour eliminated.
struct StepEquations {
  Eigen::MatrixXd normal;  ///< offsets x offsets
  Eigen::MatrixX4d right;  ///< offsets x bands

  StepEquations(const StepBasis& basis, const BinnedProfile& profile);

  /// How much the step at an offset takes from the squares.
  [[nodiscard]] double gain(Eigen::Index i) const;
  /// How much the steps at two offsets take; 0 where the bins do not tell them apart.
  [[nodiscard]] double gain(Eigen::Index i, Eigen::Index j) const;
  /// What the best single step takes from the squares.
  [[nodiscard]] double best_gain() const;
};

}  // namespace ridgeline::reconstruct
