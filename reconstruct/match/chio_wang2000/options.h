// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// Iterative matching and linking in object space (Chio and Wang 2000, section 4). The thresholds
/// are those of the paper, whose images have a ground pixel of 0.24 m; the length of a piece is in
/// ground pixels here. What the paper does not state is marked "ours".
struct ChioOptions {
  double min_piece_gsd = 0.5;  ///< dP(i), 0.12 m in the paper: shorter pieces are not reliable
  double max_rate = 1.0;       ///< largest mean rate of height change, m/m
  double max_azimuth_deg = 10.0;
  double max_flank_difference = 20.0 / 255.0;  ///< share of the range of grey values
  int min_pieces = 8;
  double max_rate_sigma = 3.0;  ///< largest standard deviation of the rates of pieces, m/m
  int min_link_pieces = 5;
  double max_link_rate_difference = 0.2;  ///< m/m

  double height_difference_m = 0.5;  ///< limit in the second to the fourth process
  /// Limit in the third and fourth process, once nothing more is found.
  double relaxed_height_difference_m = 5.0;
  double range_m = 5.0;  ///< search range of the fourth process; ours

  double min_epipolar_angle_deg = 5.0;   ///< segments below it are left to other matchers; ours
  double junction_radius_px = 5.0;       ///< largest distance of a junction from its segments; ours
  double min_junction_angle_deg = 20.0;  ///< ours
  /// Largest distance of a junction from its mate's epipolar line; ours.
  double junction_epipolar_px = 2.0;

  static constexpr auto fields() {
    using O = ChioOptions;
    return std::tuple{
        Field{"min_piece_gsd", &O::min_piece_gsd, 0.0, 100.0,
              "minimum horizontal length of a reliable edge piece, in ground pixels"},
        Field{"max_rate", &O::max_rate, 0.0, 1e3, "maximum mean rate of height change, m/m"},
        Field{"max_azimuth_deg", &O::max_azimuth_deg, 0.0, 90.0,
              "maximum difference in azimuth of two candidates"},
        Field{"max_flank_difference", &O::max_flank_difference, 0.0, 1.0,
              "maximum difference of the mean grey values next to them, as a share of their range"},
        Field{"min_pieces", &O::min_pieces, 1, 1000,
              "minimum number of reliable pieces of an initial link"},
        Field{"max_rate_sigma", &O::max_rate_sigma, 0.0, 1e3,
              "maximum standard deviation of the rates of the pieces, m/m"},
        Field{"min_link_pieces", &O::min_link_pieces, 1, 1000,
              "minimum number of reliable pieces of a further fragment"},
        Field{"max_link_rate_difference", &O::max_link_rate_difference, 0.0, 1e3,
              "maximum difference of the mean rates of linked fragments, m/m"},
        Field{"height_difference_m", &O::height_difference_m, 0.0, 1e3,
              "maximum height difference to a matched neighbour"},
        Field{"relaxed_height_difference_m", &O::relaxed_height_difference_m, 0.0, 1e3,
              "the same after no more matches are found"},
        Field{"range_m", &O::range_m, 0.0, 1e3, "search range for lines near matched ones"},
        Field{"min_epipolar_angle_deg", &O::min_epipolar_angle_deg, 0.1, 45.0,
              "segments below this angle to the epipolar line are not matched"},
        Field{"junction_radius_px", &O::junction_radius_px, 0.1, 1e3,
              "maximum distance of a junction from the ends of its segments"},
        Field{"min_junction_angle_deg", &O::min_junction_angle_deg, 0.1, 89.0,
              "minimum angle between the segments of a junction"},
        Field{"junction_epipolar_px", &O::junction_epipolar_px, 0.0, 100.0,
              "maximum distance of corresponding junctions from their epipolar lines"}};
  }
};

}  // namespace ridgeline::reconstruct
