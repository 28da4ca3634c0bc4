// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// How well two lines that are assumed to meet support a 3D point, in one image.
struct PairMeasures {
  double distance_px;  ///< distance between the segments
  /// Distance of the intersection point from its counterpart's epipolar line.
  double epipolar_distance_px;
  double angle_rad;  ///< acute angle enclosed by the segments
};

/// The smallest value of each measure over all images ("minimum" in Ok et al. 2011).
PairMeasures smallest_of_each(std::span<const PairMeasures> images);

/// T_w of Ok et al. 2011, section 3.1: points up to this weight are discarded.
inline constexpr double kMinWeight = 0.01;

/// W = t exp(-d / (2 sigma_1) - d_e / (2 sigma_2)), t = 0 for angles up to 10 degrees, else 1 (Ok
/// et al. 2011, Eq. 6, rearranged). In [0, 1].
double point_weight(const PairMeasures& measures);

/// The third of the base segment that a point falls into; the outer ones are unbounded.
enum class Region : std::uint8_t { kLeft, kCentre, kRight };
inline constexpr int kNumRegions = 3;

/// The region of a point by its parameter along the base segment, 0 at its start and 1 at its end.
Region region(double parameter);

/// An artificial point that may enter the adjustment of a line.
struct RankedPoint {
  double parameter = 0.0;  ///< along the base segment
  double weight = 0.0;     ///< W
  double omega = 0.0;      ///< omega of the point's estimation
  int neighbour = 0;       ///< index of the other track that the point was made with
};

/// Indices of the points to use, the one of highest weight in each region (Ok et al. 2011, Fig. 6),
/// in order of the regions; ties go to the smaller omega, then to the smaller neighbour. Points of
/// weight up to kMinWeight are not used.
std::vector<std::size_t> select_points(std::span<const RankedPoint> points);

}  // namespace ridgeline::reconstruct
