// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/edge_points.h"
#include "reconstruct/chio_wang2000/options.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/views/epipolar_transfer.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// P(i): where the ray of an edge point of the left image meets the candidate of the right one.
struct ChainPoint {
  int step = 0;
  Eigen::Vector3d x_in_local;  ///< m
};

/// From P(i) to P(i+1) of neighbouring edge points.
struct EdgePiece {
  int first = 0;       ///< index of P(i)
  double run_m = 0.0;  ///< dP(i), horizontal length
  double rate = 0.0;   ///< r(i), rise over run; not finite for run 0
  bool reliable = false;
};

/// What the screening asks of a chain.
struct ChainSummary {
  int n_reliable = 0;        ///< pieces
  double mean_rate = 0.0;    ///< of the reliable pieces, m/m, in the direction of the left segment
  double rate_sigma = 0.0;   ///< their standard deviation; 0 for fewer than two
  double azimuth_rad = 0.0;  ///< of the reliable pieces, clockwise from the y axis, (-pi, pi]
  double mean_height_m = 0.0;    ///< of all points
  double height_sigma_m = 0.0;   ///< of that mean, from the precision of both segments
  double height_per_px_m = 0.0;  ///< change of height when an edge point moves across its edge
};

/// The 3D edge pieces of a left segment that a right segment implies.
struct EdgeChain {
  std::vector<ChainPoint> points;
  std::vector<EdgePiece> pieces;
  ChainSummary summary;
};

/// An edge point with the image of its ray in the right image. searched_points(): those of a segment.
struct SearchedPoint {
  EdgePoint point;
  Stretch stretch;
};

std::vector<SearchedPoint> searched_points(const EpipolarTransfer& right_from_left,
                                           const ImageSampler& left_image,
                                           const EdgeSegment& left);

/// The chain of a candidate (Chio and Wang 2000, section 3): each
/// left point's epipolar line cuts the right segment, forward intersection gives P(i). Points that
/// would lie beyond the ends of the right segment by more than a pixel are left out. A piece is
/// reliable if its horizontal length is at least min_piece_gsd (or at most, see options) and its
/// rate is finite.
/// For a segment along the epipolar line the points are not finite and all are left out.
EdgeChain edge_chain(const EpipolarTransfer& right_from_left,
                     std::span<const SearchedPoint> left_points,
                     const UncertainSegment2& left,
                     const UncertainSegment2& right,
                     double gsd_m,
                     const ChioOptions& options);

/// What noise of the edge pixels alone makes of the rates of a chain, as standard deviations: of a
/// single piece and of the mean over n pieces in a row, whose noise cancels but for its ends.
double expected_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px);
double expected_mean_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px);

}  // namespace ridgeline::reconstruct
