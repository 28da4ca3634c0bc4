// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/chio_wang2000/extensions.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "reconstruct/ok2011/extract/extract_segments.h"
#include "reconstruct/ok2011/match/match_pairwise.h"

// What goes beyond the papers, in the form in which the published steps take it.

namespace ridgeline::reconstruct {

/// The extensions of the extraction that the options switch on: a second look for faint edges
/// (faint_edges), cuts of edges where others end on them (junction_cuts), and the separation of
/// edges that blur into one (close_edges).
EdgeRefinement edge_refinement(const ExtractionOptions& options);

/// The extensions of the matching that the options switch on: matched_radiometry, hidden_walls,
/// close_edges (the order of close lines) and the depth of the surfaces beside a line
/// (weigh_by_surface()).
/// @param candidates  options of the first search, which gives the radiometry
/// @param surface     the surface of the pair, or null; must live as long as the result
MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates,
                                 const Surface* surface = nullptr);

/// The extensions of the matching in object space that the options switch on.
/// @param change_look  changes the look of the candidates
ChioExtensions chio_extensions(const ChioExtensionOptions& options,
                               const CandidateLook& change_look);

/// The extensions of the estimation that the options switch on: other ends for uncertain lines,
/// depth_consensus and network.
/// @param surface_of  the surfaces of the pairs; they must live as long as the result
EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       const SurfaceOf& surface_of = no_surface);

}  // namespace ridgeline::reconstruct
