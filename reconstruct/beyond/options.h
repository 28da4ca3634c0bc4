// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"
#include "reconstruct/ok2011/estimate/options.h"
#include "reconstruct/ok2011/extract/options.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of the extensions of the extraction; see edge_refinement().
struct EdgeExtensionOptions {
  bool faint_edges = true;
  double faint_gradient_sigma_px = 1.6;
  double faint_min_length_px = 25.0;  ///< shorter edges of the second look are mostly texture
  bool junction_cuts = true;
  double min_junction_bend_px = 0.05;  ///< a cut stays if two lines fit better than one by this
  bool separate_edges = true;
  bool soft_edges = true;

  static constexpr EdgeExtensionOptions none() {
    return {
        .faint_edges = false, .junction_cuts = false, .separate_edges = false, .soft_edges = false};
  }

  static constexpr auto fields() {
    using O = EdgeExtensionOptions;
    return std::tuple{
        Field{"faint_edges", &O::faint_edges, false, true,
              "detect faint edges in a second pass with more smoothing"},
        Field{"faint_gradient_sigma_px", &O::faint_gradient_sigma_px, 0.5, 5.0,
              "smoothing of the colour gradient in the second pass"},
        Field{"faint_min_length_px", &O::faint_min_length_px, 3.0, 1e5,
              "minimum length of a segment of the second pass"},
        Field{"junction_cuts", &O::junction_cuts, false, true,
              "cut edges at junctions and crossings with other edges"},
        Field{"min_junction_bend_px", &O::min_junction_bend_px, 0.0, 100.0,
              "keep such a cut if two lines reduce the RMS of one line by at least this"},
        Field{"separate_edges", &O::separate_edges, false, true,
              "separate two edges that blur into one within about two pixels"},
        Field{"soft_edges", &O::soft_edges, false, true,
              "adapt the smoothing to the width of edges and search reduced images"}};
  }
};

/// The options of the extraction: those of the paper and those of its extensions.
struct ExtractionOptions {
  ExtractOptions edges;
  EdgeExtensionOptions beyond;
};

/// The options of the extensions of the matching; see match_extensions() and propagate_heights().
struct MatchExtensionOptions {
  bool matched_radiometry = true;
  bool close_lines = true;
  bool hidden_walls = true;
  bool propagate_heights = true;
  /// The depth of the surfaces beside a line speaks for or against its candidates. See
  /// weigh_by_surface().
  bool surface = true;
  /// Mates of unmatched segments are looked for where the surfaces beside the segments predict
  /// them. See guided_matches().
  bool guided = true;
  double guided_min_similarity = 0.8;
  /// Lines matched by height must look more alike than other lines of `chio` (its min_similarity).
  /// On the training villages 4 of 19 lines below this value were false, and none of the 6 from
  /// this value on.
  double propagate_min_similarity = 0.82;

  static constexpr MatchExtensionOptions none() {
    return {.matched_radiometry = false,
            .close_lines = false,
            .hidden_walls = false,
            .propagate_heights = false,
            .surface = false,
            .guided = false};
  }

  static constexpr auto fields() {
    using O = MatchExtensionOptions;
    return std::tuple{
        Field{"matched_radiometry", &O::matched_radiometry, false, true,
              "estimate gain and offset of the images from common surfaces"},
        Field{"close_lines", &O::close_lines, false, true,
              "keep the order of the two edges of a narrow strip"},
        Field{"hidden_walls", &O::hidden_walls, false, true,
              "compare edges across walls visible to only one camera"},
        Field{"propagate_heights", &O::propagate_heights, false, true,
              "match remaining lines at the height of matched lines that they meet"},
        Field{"surface", &O::surface, false, true,
              "select among candidates by the depth of the adjacent surfaces (dense matching)"},
        Field{"guided", &O::guided, false, true,
              "search unmatched lines in the other image where these surfaces predict them"},
        Field{"guided_min_similarity", &O::guided_min_similarity, 0.0, 1.0,
              "guided: minimum similarity"},
        Field{"propagate_min_similarity", &O::propagate_min_similarity, 0.0, 1.0,
              "propagate_heights: minimum similarity"}};
  }
};

/// The options of the extensions of the matching in object space; see chio_extensions().
struct ChioExtensionOptions {
  bool allow_noise = true;
  bool by_look = true;
  double edge_sigma_px = 0.25;  ///< sigma of a single edge pixel across its edge
  double min_similarity = 0.3;
  /// Largest ratio of the similarities of the next candidate and the best one.
  double max_similarity_ratio = 0.8;

  static constexpr ChioExtensionOptions none() { return {.allow_noise = false, .by_look = false}; }

  static constexpr auto fields() {
    using O = ChioExtensionOptions;
    return std::tuple{
        Field{"allow_noise", &O::allow_noise, false, true,
              "widen limits by noise and compare heights where lines meet; off: as published"},
        Field{"by_look", &O::by_look, false, true,
              "rank candidates by appearance; off: by their reliable pieces, as published"},
        Field{"edge_sigma_px", &O::edge_sigma_px, 1e-3, 10.0,
              "allow_noise: noise of an edge pixel across its edge"},
        Field{"min_similarity", &O::min_similarity, 0.0, 1.0,
              "by_look: minimum similarity of a match"},
        Field{"max_similarity_ratio", &O::max_similarity_ratio, 0.0, 1.0,
              "by_look: maximum ratio of the similarities of the second-best and best candidates"}};
  }
};

/// The options of the extensions of the estimation; see estimate_extensions().
struct EstimateExtensionOptions {
  /// A not_aligned line whose end is less certain than this (height) is given between the ends of
  /// the right segment, because its left segment continues far beyond a short right one.
  double max_end_sigma_m = 0.5;
  /// Right segments of not_aligned matches are moved to where the right image shows what lies under
  /// the left ones, by the colour profiles across the lines. See compare_profiles().
  bool register_profiles = true;
  /// Sigmas depend on how alike both images show the two edges of a match, and the error that both
  /// have in common is added. See own_sigma_scale() and add_shared_error().
  bool shared_errors = true;
  /// Only points that agree on the depth of the line are used. If fewer than two remain, the ends
  /// of both segments and horizontality help. See agree_on_depth().
  bool consensus = true;
  /// Dense matching of the pair tells how deep the surfaces beside each line are. See SurfaceDepth.
  /// Without it faces_beside does nothing either.
  bool surface = true;
  /// `joint` and `network` adjust lines to the plane faces that they border in the surface by dense
  /// matching. See adjust_to_faces_beside().
  bool faces_beside = true;

  /// Whether `joint` and `network` adjust lines to the plane faces beside them.
  [[nodiscard]] constexpr bool adjusts_to_faces() const { return surface && faces_beside; }

  static constexpr EstimateExtensionOptions none() {
    return {.max_end_sigma_m = 1e6,
            .register_profiles = false,
            .shared_errors = false,
            .consensus = false,
            .surface = false,
            .faces_beside = false};
  }

  static constexpr auto fields() {
    using O = EstimateExtensionOptions;
    return std::tuple{
        Field{"max_end_sigma_m", &O::max_end_sigma_m, 0.0, 1e6,
              "above this sigma of an end, a line uses the segment ends of the second image"},
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

/// How lines of buildings meet and lie, for depth_consensus and network.
struct BuildingOptions {
  double sigma_meeting_m = 0.1;  ///< sigma of the distance of lines that meet
  double max_miss_m = 2.5;       ///< largest distance of lines that only seem to meet
  double sigma_slope = 0.01;     ///< sigma of the slope of lines that are built horizontal

  static constexpr auto fields() {
    using O = BuildingOptions;
    return std::tuple{Field{"sigma_meeting_m", &O::sigma_meeting_m, 1e-4, 1e3,
                            "consensus, network: sigma of the distance of lines that meet"},
                      Field{"max_miss_m", &O::max_miss_m, 1e-3, 1e4,
                            "network: maximum distance of lines that only seem to meet"},
                      Field{"sigma_slope", &O::sigma_slope, 1e-6, 1.0,
                            "consensus, network: sigma of the slope of horizontal lines"}};
  }
};

/// The options of depth_consensus.
struct ConsensusOptions {
  double sigma_end_px = 1.0;       ///< sigma along the line of ends that show the same point
  double gable_share = 0.8;        ///< prior share of gables among what has the shape of one
  double step_share = 0.07;        ///< prior share of crossings where a row of lines has a step
  double min_cut_length_px = 7.0;  ///< least length of each part of a match that is cut
  /// A line is given no geometry if another depth explains it about as well: if the log of the odds
  /// between both depths is below this.
  double min_depth_margin = 2.5;

  static constexpr auto fields() {
    using O = ConsensusOptions;
    return std::tuple{
        Field{"sigma_end_px", &O::sigma_end_px, 1e-3, 1e3,
              "consensus: sigma of corresponding segment ends along the line"},
        Field{"gable_share", &O::gable_share, 0.0, 1.0,
              "consensus: prior probability that a gable-shaped group of lines is a gable"},
        Field{"step_share", &O::step_share, 0.0, 1.0,
              "consensus: prior probability of a step where a row of lines is crossed"},
        Field{"min_cut_length_px", &O::min_cut_length_px, 1.0, 1e6,
              "consensus: minimum length of a part of a cut match"},
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
