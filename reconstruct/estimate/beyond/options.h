// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/options.h"
#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of the extensions of the estimation; see estimate_extensions().
struct EstimateExtensionOptions {
  /// A line of two images is the part that both show, just as a line of more images is the part
  /// that two of them show. Where only one segment continues, the other image gives no evidence of
  /// its height.
  bool common_part = true;
  /// Right segments of not_aligned matches are moved to where the right image shows what lies under
  /// the left ones, according to the colour profiles across the lines. See compare_profiles().
  bool register_profiles = true;
  /// Sigmas depend on how similar the two edges of a match are, and the error common to both images
  /// is added. See own_sigma_scale() and add_shared_error().
  bool shared_errors = true;
  /// Only points that agree on the depth of the line are used. If fewer than two remain, the ends
  /// of both segments and horizontality help. See agree_on_depth().
  bool consensus = true;
  /// Dense matching of the pair gives the depth of the surfaces beside each line. See SurfaceDepth.
  /// Without it, faces_beside has no effect either.
  bool surface = true;
  /// `joint` and `network` adjust lines to the plane faces that they border in the surface from
  /// dense matching. See adjust_to_faces_beside().
  bool faces_beside = true;

  /// Whether `joint` and `network` adjust lines to the plane faces beside them.
  [[nodiscard]] constexpr bool adjusts_to_faces() const { return surface && faces_beside; }

  static constexpr EstimateExtensionOptions none() {
    return {.common_part = false,
            .register_profiles = false,
            .shared_errors = false,
            .consensus = false,
            .surface = false,
            .faces_beside = false};
  }

  static constexpr auto fields() {
    using O = EstimateExtensionOptions;
    return std::tuple{
        Field{
            "common_part", &O::common_part, false, true,
            "a line of two images ends where either of them ends it; off: at the ends of the base "
            "segment, as published"},
        Field{"register_profiles", &O::register_profiles, false, true,
              "not_aligned: shift the edge in the second image to align the profiles across it"},
        Field{"shared_errors", &O::shared_errors, false, true,
              "derive sigmas from the similarity of both edges, including errors common to both "
              "images"},
        Field{"consensus", &O::consensus, false, true,
              "use only points that agree on the depth of their line; off: as published"},
        Field{"surface", &O::surface, false, true,
              "consensus, faces_beside: use adjacent surfaces from dense matching"},
        Field{"faces_beside", &O::faces_beside, false, true,
              "joint, network: adjust lines to adjacent roof and ground planes"}};
  }
};

/// How lines of buildings meet and how level they are, for depth_consensus and network.
struct BuildingOptions {
  double sigma_meeting_m = 0.1;  ///< sigma of the distance of lines that meet
  double max_miss_m = 2.5;       ///< of lines that only seem to meet; set only by a test
  double sigma_slope = 0.01;     ///< sigma of the slope of lines that are built horizontal

  static constexpr auto fields() {
    using O = BuildingOptions;
    return std::tuple{Field{"sigma_meeting_m", &O::sigma_meeting_m, 1e-4, 1e3,
                            "consensus, network: sigma of the distance of lines that meet"},
                      Field{"sigma_slope", &O::sigma_slope, 1e-6, 1.0,
                            "consensus, network: sigma of the slope of horizontal lines"}};
  }
};

/// The options of depth_consensus.
struct ConsensusOptions {
  double gable_share = 0.8;  ///< prior share of gables among gable-shaped groups of lines
  double step_share = 0.07;  ///< prior share of crossings where a row of lines has a step
  /// A line gets no geometry if another depth explains it about as well, i.e. if the log odds
  /// between the two depths are below this.
  double min_depth_margin = 2.5;

  static constexpr auto fields() {
    using O = ConsensusOptions;
    return std::tuple{
        Field{"gable_share", &O::gable_share, 0.0, 1.0,
              "consensus: prior probability that a gable-shaped group of lines is a gable"},
        Field{"step_share", &O::step_share, 0.0, 1.0,
              "consensus: prior probability of a step where a row of lines is crossed"},
        Field{"min_depth_margin", &O::min_depth_margin, 0.0, 1e3,
              "consensus: minimum log odds against another depth; below, the line is ambiguous"}};
  }
};

/// The options of the estimation: those of the paper and those of its extensions.
struct EstimationOptions {
  ReconstructOptions lines;
  EstimateExtensionOptions beyond;
  BuildingOptions building{};
  ConsensusOptions consensus{};
};

}  // namespace ridgeline::reconstruct
