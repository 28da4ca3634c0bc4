// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <cstdint>
#include <tuple>

namespace ridgeline::evaluate {

/// Sample consensus methods of PCL that work well on roofs. RRANSAC and RMSAC can loop for ever and
/// MLESAC finds the wrong plane in two of three patches, so they are not offered.
enum class SampleConsensus : std::uint8_t { kMsac, kRansac, kProsac };

/// The minimum angle between the normals of a ridge's planes (calibration.md, thresholds of the
/// judge).
inline constexpr double kMinAngleOfRidge_deg = 10.0;

/// How lines are judged; see judge_line(). Lengths in metres of the local frame.
struct JudgeOptions {
  SampleConsensus method = SampleConsensus::kMsac;

  /// Range noise of the cloud; thresholds that depend on it are multiples of it.
  double lidar_sigma_m = 0.034;
  /// Half width of the planimetric corridor. It spans all heights, so that a line whose height is
  /// wrong by metres is still judged.
  double corridor_half_width_m = 1.5;
  /// The corridor is extended by this length at both ends of the line.
  double corridor_end_m = 0.5;
  /// Points closer to the line than this belong to neither side: they straddle the edge.
  double side_gap_m = 0.2;
  /// Points within this distance of a plane support it; 3 sigma of the cloud.
  double inlier_distance_m = 0.10;
  int min_points = 10;  ///< of a plane on one side
  /// A plane's final fit uses connected inliers up to this distance from the line, because more
  /// points give a smaller sigma.
  double fit_half_width_m = 4.0;
  double max_slope_deg = 65.0;  ///< steeper planes are walls, or wall and ground together
  double min_coverage = 0.5;    ///< of the line by the plane's inliers beside it
  /// Standard deviation of the distance of a correct line from its surface, regardless of what its
  /// tool states: the covariance in a judged file must not influence the choice of surface.
  double place_sigma_m = 0.3;
  double sigma_edge_px = 1.0;    ///< of an image segment, including its orientation
  double min_probability = 0.9;  ///< of the surface; below it, the line is ambiguous
  int max_iterations = 1000;     ///< of the sample consensus
  bool keep_points = false;      ///< whether to fill JudgedResult::inliers and inlier_points

  static constexpr auto fields() {
    using O = JudgeOptions;
    return std::tuple{
        Field{"lidar_sigma_m", &O::lidar_sigma_m, 0.0, 10.0, "range noise of the cloud"},
        Field{"corridor_half_width_m", &O::corridor_half_width_m, 0.1, 100.0,
              "half width of the corridor around a line, in plan"},
        Field{"corridor_end_m", &O::corridor_end_m, 0.0, 100.0, "extension of the corridor's ends"},
        Field{"side_gap_m", &O::side_gap_m, 0.0, 10.0,
              "points closer to the line belong to neither side"},
        Field{"inlier_distance_m", &O::inlier_distance_m, 1e-4, 10.0,
              "maximum distance of an inlier from its plane"},
        Field{"min_points", &O::min_points, 4, 1000000,
              "minimum number of points of a plane on one side"},
        Field{"fit_half_width_m", &O::fit_half_width_m, 0.1, 100.0,
              "maximum distance from the line of connected inliers in the plane fit"},
        Field{"max_slope_deg", &O::max_slope_deg, 0.0, 90.0, "steeper planes are walls, not roofs"},
        Field{"min_coverage", &O::min_coverage, 0.0, 1.0,
              "minimum share of the line covered by its plane"},
        Field{"place_sigma_m", &O::place_sigma_m, 0.001, 100.0,
              "minimum sigma of the distance of a correct line from its surface"},
        Field{"sigma_edge_px", &O::sigma_edge_px, 0.01, 100.0,
              "sigma of an image segment, including orientation"},
        Field{"min_probability", &O::min_probability, 0.5, 1.0,
              "minimum probability of the surface; below, the line is ambiguous"},
        Field{"max_iterations", &O::max_iterations, 1, 1000000,
              "maximum number of iterations of the sample consensus"}};
  }
};

}  // namespace ridgeline::evaluate
