// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/field.h"

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

}  // namespace ridgeline::reconstruct
