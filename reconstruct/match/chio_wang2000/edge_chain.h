// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/match/chio_wang2000/edge_points.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// P(i): the point in space where the ray of a left edge point meets the projection plane of the
/// right candidate.
struct ChainPoint {
  int step = 0;
  Eigen::Vector3d x_in_local;  ///< m
};

/// The piece of an edge from P(i) to P(i+1), which belong to neighbouring edge points.
struct EdgePiece {
  int first = 0;       ///< index of P(i)
  double run_m = 0.0;  ///< dP(i), horizontal length
  double rate = 0.0;   ///< r(i), rise over run; not finite for run 0
  bool reliable = false;
};

/// The properties of a chain that are tested in the screening and used in the matching.
struct ChainSummary {
  int n_reliable = 0;  ///< number of reliable pieces
  /// Mean rate of the reliable pieces, m/m, in the direction of the left segment.
  double mean_rate = 0.0;
  /// Standard deviation of the rates of the reliable pieces; 0 for fewer than two.
  double rate_sigma = 0.0;
  /// Azimuth of the reliable pieces, clockwise from the y axis, (-pi, pi].
  double azimuth_rad = 0.0;
  double mean_height_m = 0.0;   ///< mean height of all points
  double height_sigma_m = 0.0;  ///< sigma of mean_height_m, from the precision of both segments
  /// Change of height when an edge point moves by 1 px across its edge.
  double height_per_px_m = 0.0;
};

/// The 3D edge pieces that a right segment implies for a left segment.
struct EdgeChain {
  std::vector<ChainPoint> points;
  std::vector<EdgePiece> pieces;
  ChainSummary summary;
};

/// An edge point with the image of its ray in the right image.
struct SearchedPoint {
  EdgePoint point;
  Stretch stretch;
};

/// The edge points of a left segment, each with the image of its ray in the right image.
std::vector<SearchedPoint> searched_points(const EpipolarTransfer& right_from_left,
                                           const ImageSampler& left_image,
                                           const EdgeSegment& left);

/// The chain of a candidate (Chio and Wang 2000, section 3). The epipolar line of each left point
/// intersects the right segment, and forward intersection gives P(i). Points more than a pixel
/// beyond the ends of the right segment are left out. A piece is reliable if its horizontal length
/// is at least half a ground pixel and its rate is finite. For a segment along the epipolar line
/// the points are not finite and all are left out.
EdgeChain edge_chain(const EpipolarTransfer& right_from_left,
                     std::span<const SearchedPoint> left_points,
                     const UncertainSegment2& left,
                     const UncertainSegment2& right,
                     double gsd_m);

/// Standard deviation of the rate of a single piece caused by the noise of the edge pixels alone.
double expected_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px);
/// Standard deviation of the mean rate of a chain caused by the noise of the edge pixels alone. The
/// noise of consecutive pieces cancels except at the two ends of the sequence.
double expected_mean_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px);

}  // namespace ridgeline::reconstruct
