// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/conditioning.h"
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <Eigen/Core>

#include <cstdint>

namespace ridgeline {

/// An image segment with the uncertainty of the regression line through its edge pixels, expressed
/// by two uncorrelated parameters: the shift across the line at the centroid, and the direction.
struct UncertainSegment2 {
  Segment2 segment;             ///< its ends are on the regression line
  Eigen::Vector2d centroid_px;  ///< centroid of the edge pixels, on the line
  double sigma_q_px = 0.0;      ///< standard deviation across the line at the centroid
  double sigma_phi_rad = 0.0;   ///< standard deviation of the direction
  double sigma_e_px = 0.0;      ///< standard deviation of an endpoint along the line
};

/// The line through two ends with independent errors.
/// @param sigma_px  standard deviation of each end across the line
UncertainSegment2 line_of_ends(const Segment2& ends, double sigma_px);

/// How the covariance of the homogeneous line is formed.
enum class LineCovariance : std::uint8_t {
  kEq1,       ///< join of two independent endpoints (Ok et al. 2011, Eq. 1)
  kCentroid,  ///< from the centroid and the direction: exact for a regression line
};

/// The line of a segment in the conditioned image, oriented from start to end, spherically
/// normalised. The endpoints of a regression line are correlated (-2 sigma_q^2 against a variance
/// of 4 sigma_q^2 for an unweighted one). `kEq1` ignores that, as the paper does, which doubles the
/// variance across the line and reduces the variance of the direction by a third. Throws
/// std::invalid_argument unless the length, sigma_q and sigma_phi are positive.
UncertainLine2 uncertain_line(const UncertainSegment2& segment,
                              LineCovariance form,
                              const ImageConditioning& image = {});

}  // namespace ridgeline
