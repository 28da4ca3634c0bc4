// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// Options for the extensions of the extraction; see edge_refinement().
struct EdgeExtensionOptions {
  bool faint_edges = true;
  bool junction_cuts = true;
  bool separate_edges = true;
  bool soft_edges = true;

  static constexpr EdgeExtensionOptions none() {
    return {
        .faint_edges = false, .junction_cuts = false, .separate_edges = false, .soft_edges = false};
  }

  static constexpr auto fields() {
    using O = EdgeExtensionOptions;
    return std::tuple{Field{"faint_edges", &O::faint_edges, false, true,
                            "detect faint edges in a second pass with more smoothing"},
                      Field{"junction_cuts", &O::junction_cuts, false, true,
                            "cut edges at junctions and crossings with other edges"},
                      Field{"separate_edges", &O::separate_edges, false, true,
                            "separate two edges that blur into one within about two pixels"},
                      Field{"soft_edges", &O::soft_edges, false, true,
                            "adapt the smoothing to the width of edges and search reduced images"}};
  }
};

/// The options of the extraction: those of the paper's method and those of our extensions.
struct ExtractionOptions {
  ExtractOptions edges;
  EdgeExtensionOptions beyond;
};

}  // namespace ridgeline::reconstruct
