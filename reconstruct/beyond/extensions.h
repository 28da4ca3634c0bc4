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

/// What goes beyond the paper in the extraction, as the options switch it on: a second look for faint edges
/// (faint_edges), edges are cut where others end on them (junction_cuts) and edges that blur into one are resolved
/// (close_edges).
EdgeRefinement edge_refinement(const ExtractionOptions& options);

/// What goes beyond the paper in the matching, as the options switch it on: matched_radiometry, hidden_walls,
/// close_edges (the order of close lines).
/// @param candidates  of the first search, which gives the radiometry
/// @param surface     of the pair, or none; must live as long as the result
MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates,
                                 const Surface* surface = nullptr);

/// What goes beyond the paper in the matching in object space, as the options switch it on.
/// @param change_look  of the candidates
ChioExtensions chio_extensions(const ChioExtensionOptions& options,
                               const CandidateLook& change_look);

/// What goes beyond the paper in the estimation, as the options switch it on: where uncertain lines end, depth_consensus
/// and network.
/// @param surface  of the pair, or none; must live as long as the result
EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       const Surface* surface = nullptr);

}  // namespace ridgeline::reconstruct
