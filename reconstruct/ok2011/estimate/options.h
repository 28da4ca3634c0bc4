// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <array>
#include <cstdint>
#include <tuple>

namespace ridgeline::reconstruct {

enum class Method : std::uint8_t { kDirect, kJoint, kNetwork };
inline constexpr std::array kMethods{Method::kDirect, Method::kJoint, Method::kNetwork};
const char* name(Method method);  ///< "direct" | "joint" | "network"

/// The method of Ok et al. 2011, section 3. Ours are `consensus` with all that belongs to it,
/// `flanks`, `register_profiles`, `max_end_sigma_m` and Method::kNetwork.
struct ReconstructOptions {
  Method method = Method::kJoint;
  /// Of `direct` and `joint` alike, so that both treat a not_aligned line identically.
  LineCovariance line_covariance = LineCovariance::kEq1;

  double max_aligned_angle_deg = kMaxAlignedAngle_deg;  ///< up to here a line is `aligned`
  double sigma_distance_px = 5.0;    ///< sigma_1 of Eq. 6: distance of the two segments
  double sigma_epipolar_px = 2.0;    ///< sigma_2 of Eq. 6: distance to the epipolar line
  double min_pair_angle_deg = 10.0;  ///< a pair up to this angle gives no point (t of Eq. 6)
  double min_weight = 0.01;          ///< T_w: points up to this weight are discarded
  /// A not_aligned line whose end is less certain than this (height) is given between the ends of the
  /// right segment: its left one continues far beyond a short right one. Not in the paper.
  double max_end_sigma_m = 0.5;
  /// Right segments of not_aligned matches are moved to where their image shows what the left ones lie
  /// on, by the colour profiles across the lines. See registered_shifts_px(). Not in the paper.
  bool register_profiles = true;
  /// Only points that agree on the depth of the line are used, and where fewer than two remain, what
  /// the ends of both segments and horizontality tell. See agree_on_depth().
  bool consensus = true;
  /// The consensus hears how the strips beside the line correlate at each depth. See FlankCorrelation.
  bool flanks = true;
  double sigma_flank_px = 0.5;   ///< of points of the line found so, along the line
  double max_point_prior = 0.7;  ///< that two lines which cross in both images meet, at W = 1
  double end_prior = 0.75;       ///< that the ends of both segments show the same point
  double sigma_end_px = 1.0;     ///< along the line, if they do
  /// Lines that rest on their ends alone are at least this long: false matches of short segments have
  /// ends that agree as well.
  double min_ends_length_px = 15.0;
  double sigma_meeting_m = 0.1;     ///< distance of lines that meet
  double max_miss_m = 2.5;          ///< of lines that only seem to meet
  double doubt_above = 0.1;         ///< that a point above the line is none: less than below it
  double horizontal_share = 0.8;    ///< of the aligned lines, before anything is known
  double sigma_slope = 0.01;        ///< of lines that are built horizontal
  double nearby_px = 100.0;         ///< from the line, in the base image, heights are compared
  double sigma_height_m = 0.2;      ///< of lines at the same height
  double max_nearby_sigma_m = 0.4;  ///< of the height of a line that others are compared with
  /// Most that agreement with the line raises the odds of evidence by.
  double agreement_gain = 4.0;
  double gable_share = 0.8;        ///< of gables among what has the shape of one
  double step_share = 0.07;        ///< of places where one crosses: steps of a row
  double min_cut_weight = 0.3;     ///< W of the point where a match is cut
  double min_cut_length_px = 7.0;  ///< of each part
  /// Lines that another depth explains as well to this (log of the ratio) are given no geometry.
  double min_depth_margin = 2.5;
  /// Artificial points outside the range of heights (local frame) are discarded. No limit on Earth. Of
  /// the patch, not options of a user: not among the fields.
  double lowest_height_m = -1e5;
  double highest_height_m = 1e5;

  static constexpr auto fields() {
    using O = ReconstructOptions;
    return std::tuple{
        Field{"max_aligned_angle_deg", &O::max_aligned_angle_deg, 0.0, 90.0,
              "largest angle to the epipolar line of the class aligned"},
        Field{"sigma_distance_px", &O::sigma_distance_px, 1e-3, 1e4,
              "weight of a point: scale of the distance of its two segments"},
        Field{"sigma_epipolar_px", &O::sigma_epipolar_px, 1e-3, 1e4,
              "weight of a point: scale of its distance to the epipolar line"},
        Field{"min_pair_angle_deg", &O::min_pair_angle_deg, 0.0, 90.0,
              "weight of a point: 0 up to this angle of its two segments"},
        Field{"min_weight", &O::min_weight, 0.0, 1.0, "points up to this weight are discarded"},
        Field{"max_end_sigma_m", &O::max_end_sigma_m, 0.0, 1e6,
              "lines less certain than this at an end are given between the right ends"},
        Field{"register_profiles", &O::register_profiles, false, true,
              "not_aligned: move the right edge to where the profiles across it agree"},
        Field{"consensus", &O::consensus, false, true,
              "use points that agree on the depth of their line; off: as published"},
        Field{"flanks", &O::flanks, false, true,
              "consensus: compare the strips beside the line in both images"},
        Field{"sigma_flank_px", &O::sigma_flank_px, 1e-3, 1e3,
              "consensus: scatter of points found by that along the line"},
        Field{"max_point_prior", &O::max_point_prior, 0.01, 0.99,
              "consensus: prior probability of the best point"},
        Field{"end_prior", &O::end_prior, 0.01, 0.99,
              "consensus: prior probability that segment ends correspond"},
        Field{"sigma_end_px", &O::sigma_end_px, 1e-3, 1e3,
              "consensus: scatter of corresponding segment ends along the line"},
        Field{"min_ends_length_px", &O::min_ends_length_px, 0.0, 1e4,
              "consensus: shorter lines that no point supports are ambiguous"},
        Field{"sigma_meeting_m", &O::sigma_meeting_m, 1e-4, 1e3,
              "consensus, network: distance of lines that meet"},
        Field{"max_miss_m", &O::max_miss_m, 1e-3, 1e4,
              "network: distance of lines that only seem to meet"},
        Field{"doubt_above", &O::doubt_above, 0.0, 1.0,
              "consensus: doubt about a point above the line, where below it is 1"},
        Field{"horizontal_share", &O::horizontal_share, 0.0, 0.999,
              "consensus: prior share of horizontal lines"},
        Field{"sigma_slope", &O::sigma_slope, 1e-6, 1.0,
              "consensus: scatter of the slope of horizontal lines"},
        Field{"nearby_px", &O::nearby_px, 0.0, 1e4,
              "consensus: heights of lines up to this distance are likely ones"},
        Field{"sigma_height_m", &O::sigma_height_m, 1e-3, 1e3,
              "consensus: scatter of lines at the same height"},
        Field{"max_nearby_sigma_m", &O::max_nearby_sigma_m, 0.0, 1e3,
              "consensus: sigma of the height of a line that others are compared with"},
        Field{"agreement_gain", &O::agreement_gain, 1e-3, 1e6,
              "consensus: most that agreement raises the odds of a point by"},
        Field{"gable_share", &O::gable_share, 0.0, 1.0,
              "consensus: prior share of gables among what has the shape of one"},
        Field{"step_share", &O::step_share, 0.0, 1.0,
              "consensus: prior share of crossings where a row of lines has a step"},
        Field{"min_cut_weight", &O::min_cut_weight, 0.0, 1.0,
              "consensus: weight of a point that a match is cut at"},
        Field{"min_cut_length_px", &O::min_cut_length_px, 1.0, 1e6,
              "consensus: shortest part of a match that is cut"},
        Field{"min_depth_margin", &O::min_depth_margin, 0.0, 1e3,
              "consensus: a line is ambiguous if another depth comes closer; log of the odds"}};
  }
};

/// Ok et al. 2011, section 3, to the letter: without `consensus`, all lines between their left ends.
inline ReconstructOptions published_options() {
  ReconstructOptions options;
  options.consensus = false;
  options.flanks = false;
  options.register_profiles = false;
  options.max_end_sigma_m = 1e6;
  return options;
}

}  // namespace ridgeline::reconstruct
